#include "compiler/index/object_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "compiler/index/packing.h"
#include "compiler/scene/ear_clipping.h"
#include "compiler/scene/scene_extent.h"
#include "runtime/recognition/object_model.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

constexpr double kTurn = 2 * std::numbers::pi;

// A circle about `centre`, as a polygon whose sides stray by at most `error` from it: half of that
// to either side. The same circle always gives the same corners, so that neighbours meet.
struct Rim {
  Eigen::Vector3d centre, x, y;
  double radius = 0;

  Rim(const Eigen::Vector3d& at, const Eigen::Vector3d& axis_unit, double r)
      : centre(at), radius(r) {
    Eigen::Vector3d axis = axis_unit;
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    if (axis[largest] < 0) axis = -axis;
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    x = axis.cross(Eigen::Vector3d::Unit(least)).normalized();
    y = axis.cross(x);
  }

  Eigen::Vector3d corner(int k, int sides) const {
    const double angle = kTurn * k / sides, stretched = radius * stretch(sides);
    return centre + stretched * (std::cos(angle) * x + std::sin(angle) * y);
  }

  static double stretch(int sides) { return 2 / (1 + std::cos(kTurn / 2 / sides)); }
};

int sides_of(double radius, double error) {
  constexpr int kLeast = 8, kMost = 96;
  for (int sides = kLeast; sides < kMost; sides += 4)
    if (radius * (Rim::stretch(sides) - 1) <= error) return sides;
  return kMost;
}

bool same(const fb::Paint& a, const fb::Paint& b) {
  return a.red() == b.red() && a.green() == b.green() && a.blue() == b.blue();
}

class Facets {
 public:
  explicit Facets(const Scene& scene) : scene_(scene) {
    const SceneExtent extent = scene_extent(scene);
    // Half is left for the grid and for corners that are moved to it.
    error_ = kModelError * extent.diameter / 2;
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(error_);
    model_.least = extent.least - margin;
    model_.unit = (extent.most - extent.least + 2 * margin) / 65535;
    model_.error = error_ + model_.unit.norm() / 2;
  }

  PackedModel run() {
    for (const Primitive& primitive : scene_.primitives) {
      paint_ = paint_of(scene_.surfaces[static_cast<std::size_t>(primitive.surface)]);
      std::visit([this](const auto& shape) { add(shape); }, primitive.shape);
      if (is_too_large()) return {};
    }
    return std::move(model_);
  }

 private:
  bool is_too_large() const {
    return model_.vertices.size() > kMaxModelVertices ||
           model_.triangles.size() > kMaxModelTriangles || model_.paints.size() > kMaxModelColours;
  }

  std::uint16_t paint_of(const Surface& surface) {
    const Eigen::Vector3d& c = surface.diffuse;
    const double most = std::max(1.0, c.maxCoeff());
    const fb::Paint paint(packed<std::uint8_t>(c.x() / most, 255),
                          packed<std::uint8_t>(c.y() / most, 255),
                          packed<std::uint8_t>(c.z() / most, 255));
    for (std::size_t k = 0; k < model_.paints.size(); ++k)
      if (same(model_.paints[k], paint)) return static_cast<std::uint16_t>(k);
    model_.paints.push_back(paint);
    return static_cast<std::uint16_t>(model_.paints.size() - 1);
  }

  std::uint16_t vertex(const Eigen::Vector3d& p) {
    std::array<std::uint16_t, 3> place{};
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      place[static_cast<std::size_t>(axis)] = packed<std::uint16_t>(
          model_.unit[axis] > 0 ? (p[axis] - model_.least[axis]) / model_.unit[axis] : 0, 1);
    const auto [found, is_new] =
        vertex_at_.try_emplace(place, static_cast<std::uint16_t>(model_.vertices.size()));
    if (is_new && !is_too_large()) model_.vertices.emplace_back(place[0], place[1], place[2]);
    return found->second;
  }

  void add_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    if (is_too_large()) return;
    const std::uint16_t i = vertex(a), j = vertex(b), k = vertex(c);
    if (i != j && j != k && k != i) model_.triangles.emplace_back(i, j, k, paint_);
  }

  void add(const Polygon& polygon) {
    for (const Triangle& t : triangulate(polygon.vertices))
      add_triangle(polygon.vertices[t[0]], polygon.vertices[t[1]], polygon.vertices[t[2]]);
  }

  void add(const Mesh& mesh) {
    for (const auto& t : mesh.triangles)
      add_triangle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  }

  void add(const SmoothTriangle& t) { add_triangle(t.vertices[0], t.vertices[1], t.vertices[2]); }

  void add_band(const Rim& low, const Rim& high, int sides) {
    for (int k = 0; k < sides; ++k) {
      const Eigen::Vector3d a = low.corner(k, sides), b = low.corner(k + 1, sides),
                            c = high.corner(k + 1, sides), d = high.corner(k, sides);
      add_triangle(a, b, c);
      add_triangle(a, c, d);
    }
  }

  void add(const Ring& ring) {
    add_band({ring.center, ring.normal, ring.min_radius},
             {ring.center, ring.normal, ring.max_radius}, sides_of(ring.max_radius, error_));
  }

  void add(const Cone& cone) {
    const Eigen::Vector3d axis = (cone.apex - cone.base).normalized();
    add_band({cone.base, axis, cone.base_radius}, {cone.apex, axis, cone.apex_radius},
             sides_of(std::max(cone.base_radius, cone.apex_radius), error_));
  }

  void add(const Sphere& sphere) {
    const int sides = sides_of(sphere.radius, error_ / 3), bands = sides / 2;
    const double radius = sphere.radius * Rim::stretch(sides);
    const auto rim = [&](int band) {
      const double angle = kTurn / 2 * band / bands;
      return Rim(sphere.center - radius * std::cos(angle) * Eigen::Vector3d::UnitZ(),
                 Eigen::Vector3d::UnitZ(), sphere.radius * std::sin(angle));
    };
    for (int band = 0; band < bands; ++band) add_band(rim(band), rim(band + 1), sides);
  }

  const Scene& scene_;
  double error_ = 0;
  std::uint16_t paint_ = 0;
  std::map<std::array<std::uint16_t, 3>, std::uint16_t> vertex_at_;
  PackedModel model_;
};

}  // namespace

PackedModel packed_model(const Scene& scene) {
  if (scene.primitives.empty()) return {};
  return Facets(scene).run();
}

}  // namespace aspect
