#include "compiler/scene/bob_shapes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

// Scenes give four decimals and more; a vertex this far off its plane, as a part of the polygon's
// size, is far below a pixel.
constexpr double kPlanarTolerance = 1e-4;

// A polygon with less area than this part of its squared size is a line.
constexpr double kLeastArea = 1e-9;

// Shorter lengths in the scene cannot be told from rounding.
constexpr double kLeastLength = 1e-9;

struct PolygonMeasure {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // its length is twice the area
  double size = 0;                                   // twice the farthest vertex from the centre
};

// Newell's method: right for concave polygons, and an average where the plane is not exact.
PolygonMeasure measured(const Polygon& polygon) {
  PolygonMeasure measure;
  const auto& vertices = polygon.vertices;
  for (const Eigen::Vector3d& vertex : vertices) measure.center += vertex;
  measure.center /= static_cast<double>(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Vector3d from = vertices[i] - measure.center;
    const Eigen::Vector3d to = vertices[(i + 1) % vertices.size()] - measure.center;
    measure.normal += from.cross(to);
    measure.size = std::max(measure.size, 2 * from.norm());
  }
  return measure;
}

bool has_area(const PolygonMeasure& measure) {
  return measure.size >= kLeastLength &&
         measure.normal.norm() / 2 > kLeastArea * measure.size * measure.size;
}

}  // namespace

std::optional<BobShapes::Shape> BobShapes::read(const BobWord& statement) {
  if (statement.text == "polygon") return read_polygon(statement);
  if (statement.text == "patch") return read_patch(statement);
  if (statement.text == "sphere") return read_sphere(statement);
  if (statement.text == "ring") return read_ring(statement);
  if (statement.text == "cone" || statement.text == "cylinder") return read_cone(statement);
  return std::nullopt;
}

std::size_t BobShapes::read_point_count(const BobWord& word) {
  const double count = numbers_.number();
  if (count != std::floor(count) || count < 3) {
    words_.fail(word, fmt::format("points {:g}; write a whole number from 3", count));
  }
  const std::size_t left = kMaxPoints - points_;
  if (count > static_cast<double>(left)) {
    words_.fail(word,
                fmt::format("more than {} polygon points in the scene; write fewer", kMaxPoints));
  }
  return static_cast<std::size_t>(count);
}

Polygon BobShapes::read_polygon(const BobWord& statement) {
  Polygon polygon;
  std::size_t count = 0;
  BobBlock fields = block(statement);
  fields.field("points", [&](const BobWord& word) { count = read_point_count(word); });
  fields.repeated("vertex", [&](const BobWord& word) {
    if (count == 0) words_.fail(word, "vertex before points; write points N first");
    if (polygon.vertices.size() == count) {
      words_.fail(word, fmt::format("points {}, but more vertices follow; write as many as points "
                                    "says",
                                    count));
    }
    polygon.vertices.push_back(numbers_.vector());
  });
  fields.read();
  fields.require("points", "points N, then N times vertex x y z");
  if (polygon.vertices.size() != count) {
    words_.fail(statement, fmt::format("points {}, but {} vertices; write as many as points says",
                                       count, polygon.vertices.size()));
  }
  check_polygon(polygon, statement);
  for (Eigen::Vector3d& vertex : polygon.vertices) vertex = placed(vertex, statement);
  if (!has_area(measured(polygon))) {
    words_.fail(statement, "the transforms leave this polygon no area; scale less");
  }
  points_ += count;
  return polygon;
}

SmoothTriangle BobShapes::read_patch(const BobWord& statement) {
  SmoothTriangle patch;
  std::size_t vertices = 0, normals = 0;
  BobBlock fields = block(statement);
  fields.repeated("vertex", [&](const BobWord& word) {
    if (vertices == 3) words_.fail(word, "a fourth vertex; a patch has three");
    patch.vertices[vertices++] = numbers_.vector();
  });
  fields.repeated("normal", [&](const BobWord& word) {
    if (normals == vertices) words_.fail(word, "a normal without its vertex; write vertex first");
    patch.normals[normals++] = numbers_.vector();
    if (patch.normals[normals - 1].norm() >= kLeastLength) return;
    words_.fail(word, "the normal has no length; write a direction such as 0 0 1");
  });
  fields.read();
  if (vertices != 3 || normals != 3) {
    words_.fail(statement, fmt::format("{} vertices and {} normals in patch; write three times "
                                       "vertex x y z normal x y z",
                                       vertices, normals));
  }
  const Eigen::Affine3d& scene_from_written = transforms_.scene_from_written();
  const Eigen::Matrix3d normals_from_written = scene_from_written.linear().inverse().transpose();
  for (Eigen::Vector3d& vertex : patch.vertices) vertex = placed(vertex, statement);
  for (Eigen::Vector3d& normal : patch.normals)
    normal = (normals_from_written * normal.normalized()).normalized();
  check_patch(patch, statement);
  return patch;
}

void BobShapes::check_patch(const SmoothTriangle& patch, const BobWord& statement) const {
  const PolygonMeasure measure = measured({{patch.vertices.begin(), patch.vertices.end()}});
  if (!has_area(measure)) {
    words_.fail(statement, "the patch has no area; give three vertices that are not on one line");
  }
  for (const Eigen::Vector3d& normal : patch.normals)
    if (!normal.allFinite()) words_.fail(statement, "the transforms spoil a normal; scale less");
}

void BobShapes::check_polygon(const Polygon& polygon, const BobWord& statement) const {
  const PolygonMeasure measure = measured(polygon);
  if (!has_area(measure)) {
    words_.fail(statement, "the polygon has no area; give three vertices that are not on one line");
  }
  const Eigen::Vector3d normal = measure.normal.normalized();
  double deviation = 0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const double distance = std::fabs(normal.dot(polygon.vertices[i] - measure.center));
    if (distance <= deviation) continue;
    deviation = distance;
    worst = i + 1;
  }
  if (deviation <= kPlanarTolerance * measure.size) return;
  words_.fail(
      statement,
      fmt::format("the polygon is not planar: vertex {} is {:.4g} off its plane; move it or "
                  "write triangles",
                  worst, deviation));
}

void BobShapes::check_radius(double radius, std::string_view name, const BobWord& statement) const {
  if (radius >= 0) return;
  words_.fail(statement, fmt::format("{} {:g} of {} is negative; write 0 or more", name, radius,
                                     statement.text));
}

double BobShapes::round_factor(const BobWord& statement) const {
  const std::optional<double> factor = transforms_.length_factor();
  if (factor) return *factor;
  words_.fail(statement, fmt::format("a {} cannot be scaled differently along its axes; write "
                                     "scale with one number",
                                     statement.text));
}

Eigen::Vector3d BobShapes::placed(const Eigen::Vector3d& written, const BobWord& statement) const {
  const Eigen::Vector3d point = transforms_.scene_from_written() * written;
  if (point.cwiseAbs().maxCoeff() <= BobNumbers::kMaxNumber) return point;
  words_.fail(statement, fmt::format("the transforms move it beyond +-{:g}; scale less",
                                     BobNumbers::kMaxNumber));
}

double BobShapes::placed_radius(double written, const BobWord& statement) const {
  const double radius = written * round_factor(statement);
  if (radius >= kLeastLength && radius <= BobNumbers::kMaxNumber) return radius;
  words_.fail(statement, fmt::format("a radius of {:g} in the scene; write one within {:g} .. {:g}",
                                     radius, kLeastLength, BobNumbers::kMaxNumber));
}

Sphere BobShapes::read_sphere(const BobWord& statement) {
  Sphere sphere;
  BobBlock fields = block(statement);
  fields.vector("center", sphere.center);
  fields.number("radius", sphere.radius);
  fields.read();
  fields.require("center", "center x y z");
  fields.require("radius", "radius r");
  check_radius(sphere.radius, "radius", statement);
  sphere.center = placed(sphere.center, statement);
  sphere.radius = placed_radius(sphere.radius, statement);
  return sphere;
}

Ring BobShapes::read_ring(const BobWord& statement) {
  Ring ring;
  BobBlock fields = block(statement);
  fields.vector("center", ring.center);
  fields.vector("normal", ring.normal);
  fields.number("min_radius", ring.min_radius);
  fields.number("max_radius", ring.max_radius);
  fields.number("radius", ring.max_radius);
  fields.read();
  fields.require("center", "center x y z");
  fields.require("normal", "normal x y z");
  if (!fields.has("radius")) fields.require("max_radius", "max_radius r");
  if (fields.has("radius") && fields.has("max_radius")) {
    words_.fail(statement, "radius and max_radius are the same; write one of them");
  }
  check_radius(ring.min_radius, "min_radius", statement);
  check_radius(ring.max_radius, "max_radius", statement);
  if (ring.min_radius >= ring.max_radius) {
    words_.fail(statement, fmt::format("min_radius {:g} is not below max_radius {:g}; the ring has "
                                       "no area",
                                       ring.min_radius, ring.max_radius));
  }
  if (ring.normal.norm() < kLeastLength) {
    words_.fail(statement, "the normal has no length; write a direction such as 0 0 1");
  }
  const double factor = round_factor(statement);
  ring.center = placed(ring.center, statement);
  ring.normal =
      (transforms_.scene_from_written().linear() / factor * ring.normal.normalized()).normalized();
  ring.min_radius *= factor;
  ring.max_radius = placed_radius(ring.max_radius, statement);
  return ring;
}

Cone BobShapes::read_cone(const BobWord& statement) {
  Cone cone;
  double radius = 0;
  BobBlock fields = block(statement);
  fields.vector("base", cone.base);
  fields.vector("apex", cone.apex);
  fields.number("base_radius", cone.base_radius);
  fields.number("apex_radius", cone.apex_radius);
  fields.number("radius", radius);
  fields.read();
  fields.require("base", "base x y z");
  fields.require("apex", "apex x y z");
  if (!fields.has("radius")) {
    fields.require("base_radius", "base_radius r and apex_radius r, or radius r for both");
    fields.require("apex_radius", "base_radius r and apex_radius r, or radius r for both");
  } else if (fields.has("base_radius") || fields.has("apex_radius")) {
    words_.fail(statement, "radius stands for both ends; leave out base_radius and apex_radius");
  } else {
    cone.base_radius = cone.apex_radius = radius;
  }
  check_radius(cone.base_radius, fields.has("radius") ? "radius" : "base_radius", statement);
  check_radius(cone.apex_radius, "apex_radius", statement);
  // Each end is placed by itself; the larger one decides whether the cone is worth keeping.
  const double factor = round_factor(statement);
  placed_radius(std::max(cone.base_radius, cone.apex_radius), statement);
  cone.base = placed(cone.base, statement);
  cone.apex = placed(cone.apex, statement);
  cone.base_radius *= factor;
  cone.apex_radius *= factor;
  if ((cone.apex - cone.base).norm() < kLeastLength) {
    words_.fail(statement, fmt::format("the base of this {} equals its apex; move one of them",
                                       statement.text));
  }
  return cone;
}

}  // namespace aspect
