#include "compiler/render/scene_outline.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace aspect {
namespace {

using Eigen::Vector3d;

// A dodecagon around a circle has 2 % more area than it, one inside 5 % less.
constexpr std::uint32_t kSides = 12;

// Farther from its plane than this share of its size, a polygon's triangles are several planes.
constexpr double kFlatness = 1e-6;

class Builder {
 public:
  explicit Builder(const Scene& scene, std::span<const std::vector<Triangle>> triangles) {
    for (std::uint32_t k = 0; k < scene.primitives.size(); ++k) {
      triangles_ = triangles[k];
      SceneOutline::Frame frame;
      frame.first_point = end_point();
      frame.first_edge = static_cast<std::uint32_t>(outline_.edges.size());
      std::visit([&](const auto& shape) { add(shape, k, frame); }, scene.primitives[k].shape);
      frame.end_point = end_point();
      frame.end_edge = static_cast<std::uint32_t>(outline_.edges.size());
      outline_.frames.push_back(frame);
    }
  }

  SceneOutline take() { return std::move(outline_); }

 private:
  std::uint32_t end_point() const { return static_cast<std::uint32_t>(outline_.points.size()); }

  void add_loop(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k)
      outline_.edges.push_back({first + k, first + (k + 1) % count});
  }

  std::uint32_t add_circle_points(const Vector3d& center, const Vector3d& axis, double radius) {
    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    const std::uint32_t first = end_point();
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const double angle = 2 * std::numbers::pi * k / kSides;
      outline_.points.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return first;
  }

  std::uint32_t add_loop_around(const Vector3d& center, const Vector3d& axis, double radius) {
    const double outer = radius / std::cos(std::numbers::pi / kSides);
    const std::uint32_t first = add_circle_points(center, axis, outer);
    add_loop(first, kSides);
    return first;
  }

  template <typename Corners>
  void add_plate(std::uint32_t primitive, std::uint32_t first_point, const Corners& corners) {
    SceneOutline::Plate plate;
    plate.primitive = primitive;
    plate.first_corner = static_cast<std::uint32_t>(outline_.corners.size());
    for (const std::uint32_t corner : corners) outline_.corners.push_back(first_point + corner);
    plate.end_corner = static_cast<std::uint32_t>(outline_.corners.size());
    outline_.plates.push_back(plate);
  }

  void add(const Polygon& polygon, std::uint32_t primitive, SceneOutline::Frame& frame) {
    const std::uint32_t first = end_point();
    const auto count = static_cast<std::uint32_t>(polygon.vertices.size());
    for (const Vector3d& vertex : polygon.vertices) outline_.points.push_back(vertex);
    add_loop(first, count);

    frame.on_plane = polygon.vertices.front();
    frame.normal = polygon_normal(polygon.vertices);
    frame.flat = !frame.normal.isZero();
    for (const Vector3d& vertex : polygon.vertices) {
      const Vector3d offset = vertex - frame.on_plane;
      if (std::abs(frame.normal.dot(offset)) > kFlatness * offset.norm()) frame.flat = false;
    }
    if (!frame.flat) return;
    if (is_convex(polygon.vertices)) {
      std::vector<std::uint32_t> all(count);
      for (std::uint32_t k = 0; k < count; ++k) all[k] = k;
      add_plate(primitive, first, all);
    } else {
      for (const Triangle& triangle : triangles_) add_plate(primitive, first, triangle);
    }
  }

  void add(const SmoothTriangle& triangle, std::uint32_t primitive, SceneOutline::Frame& frame) {
    const auto& [a, b, c] = triangle.vertices;
    add(Polygon{{a, b, c}}, primitive, frame);
  }

  // Around a sphere stands an icosahedron: 20 % more area than its picture, from everywhere.
  void add(const Sphere& sphere, std::uint32_t, SceneOutline::Frame&) {
    constexpr double phi = std::numbers::phi;
    const double outer = sphere.radius * 1.2584085723648188;  // over the inscribed sphere's radius
    const double unit = outer / std::sqrt(1 + phi * phi);
    const std::uint32_t first = end_point();
    for (int axis = 0; axis < 3; ++axis)
      for (const double a : {-1.0, 1.0})
        for (const double b : {-phi, phi}) {
          Vector3d corner = Vector3d::Zero();
          corner[(axis + 1) % 3] = a * unit;
          corner[(axis + 2) % 3] = b * unit;
          outline_.points.push_back(sphere.center + corner);
        }
    const double longest_edge = 2.1 * unit;  // an edge measures 2 units, the next distance 3.2
    for (std::uint32_t from = first; from < end_point(); ++from)
      for (std::uint32_t to = from + 1; to < end_point(); ++to)
        if ((outline_.points[from] - outline_.points[to]).norm() < longest_edge)
          outline_.edges.push_back({from, to});
  }

  void add(const Ring& ring, std::uint32_t primitive, SceneOutline::Frame& frame) {
    add_loop_around(ring.center, ring.normal, ring.max_radius);
    frame.on_plane = ring.center;
    frame.normal = ring.normal;
    frame.flat = true;
    if (ring.min_radius > 0) return;
    std::array<std::uint32_t, kSides> corners{};
    for (std::uint32_t k = 0; k < kSides; ++k) corners[k] = k;
    add_plate(primitive, add_circle_points(ring.center, ring.normal, ring.max_radius), corners);
  }

  void add(const Cone& cone, std::uint32_t, SceneOutline::Frame&) {
    const Vector3d axis = (cone.apex - cone.base).normalized();
    const std::uint32_t base = add_loop_around(cone.base, axis, cone.base_radius);
    const std::uint32_t apex = add_loop_around(cone.apex, axis, cone.apex_radius);
    for (std::uint32_t k = 0; k < kSides; ++k) outline_.edges.push_back({base + k, apex + k});
  }

  // A box around all of it: the work of a view must not grow with the triangles.
  void add(const Mesh& mesh, std::uint32_t, SceneOutline::Frame&) {
    Vector3d least = mesh.vertices[mesh.triangles.front()[0]], greatest = least;
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle) {
        least = least.cwiseMin(mesh.vertices[corner]);
        greatest = greatest.cwiseMax(mesh.vertices[corner]);
      }
    const std::uint32_t first = end_point();
    for (std::uint32_t k = 0; k < 8; ++k) {
      Vector3d corner = least;
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        if ((k >> axis & 1U) != 0)
          corner[axis] = greatest[axis];
        else
          outline_.edges.push_back({first + k, first + (k | 1U << axis)});
      }
      outline_.points.push_back(corner);
    }
  }

  SceneOutline outline_;
  std::span<const Triangle> triangles_;  // of the primitive at work
};

}  // namespace

SceneOutline outline_of(const Scene& scene, std::span<const std::vector<Triangle>> triangles) {
  return Builder(scene, triangles).take();
}

}  // namespace aspect
