#include "compiler/index/object_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "compiler/index/packing.h"
#include "compiler/index/surface_simplification.h"
#include "compiler/scene/ear_clipping.h"
#include "compiler/scene/scene_extent.h"
#include "runtime/recognition/object_model.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

constexpr double kTurn = 2 * std::numbers::pi;

// More are simplified: a device draws some dozen models for a frame, and has few KiB for each.
constexpr std::size_t kEnoughTriangles = 2000;
// More are no object to hold.
constexpr std::size_t kMostTriangles = 4U << 20U;

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

int squared_distance(const fb::Paint& a, const fb::Paint& b) {
  const int r = a.red() - b.red(), g = a.green() - b.green(), blue = a.blue() - b.blue();
  return r * r + g * g + blue * blue;
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
    if (surface_.triangles.size() > kEnoughTriangles) {
      SimplifiedSurface simplified = simplified_surface(surface_, kEnoughTriangles, error_);
      surface_ = std::move(simplified.surface);
      model_.error += simplified.error;
    }
    return model_of_surface();
  }

 private:
  bool is_too_large() const { return surface_.triangles.size() > kMostTriangles; }

  // Only what triangles have.
  PackedModel model_of_surface() {
    if (surface_.triangles.size() > kMaxModelTriangles) return {};
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    std::vector<std::uint32_t> place_of(surface_.points.size(), kNone);
    for (const ColouredTriangle& t : surface_.triangles) {
      std::array<std::uint16_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t& place = place_of[t.corners[k]];
        if (place == kNone) {
          if (model_.vertices.size() == kMaxModelVertices) return {};
          place = static_cast<std::uint32_t>(model_.vertices.size());
          const std::array<std::uint16_t, 3> at = grid_place(surface_.points[t.corners[k]]);
          model_.vertices.emplace_back(at[0], at[1], at[2]);
        }
        corners[k] = static_cast<std::uint16_t>(place);
      }
      model_.triangles.emplace_back(corners[0], corners[1], corners[2], t.paint);
    }
    return std::move(model_);
  }

  std::array<std::uint16_t, 3> grid_place(const Eigen::Vector3d& p) const {
    std::array<std::uint16_t, 3> place{};
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      place[static_cast<std::size_t>(axis)] = packed<std::uint16_t>(
          model_.unit[axis] > 0 ? (p[axis] - model_.least[axis]) / model_.unit[axis] : 0, 1);
    return place;
  }

  std::uint16_t paint_of(const Surface& surface) {
    const Eigen::Vector3d& c = surface.diffuse;
    const double most = std::max(1.0, c.maxCoeff());
    const fb::Paint paint(packed<std::uint8_t>(c.x() / most, 255),
                          packed<std::uint8_t>(c.y() / most, 255),
                          packed<std::uint8_t>(c.z() / most, 255));
    std::size_t nearest = 0;
    int least = -1;
    for (std::size_t k = 0; k < model_.paints.size(); ++k) {
      const int distance = squared_distance(model_.paints[k], paint);
      if (least >= 0 && distance >= least) continue;
      least = distance;
      nearest = k;
    }
    // What is one colour too many has that of the nearest.
    if (least == 0 || model_.paints.size() == kMaxModelColours)
      return static_cast<std::uint16_t>(nearest);
    model_.paints.push_back(paint);
    return static_cast<std::uint16_t>(model_.paints.size() - 1);
  }

  std::uint32_t vertex(const Eigen::Vector3d& p) {
    const std::array<std::uint16_t, 3> place = grid_place(p);
    const auto [found, is_new] =
        vertex_at_.try_emplace(place, static_cast<std::uint32_t>(surface_.points.size()));
    if (is_new)
      surface_.points.push_back(
          model_.least + model_.unit.cwiseProduct(Eigen::Vector3d(place[0], place[1], place[2])));
    return found->second;
  }

  void add_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    if (is_too_large()) return;
    const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
    if (i != j && j != k && k != i) surface_.triangles.push_back({{i, j, k}, paint_});
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

  // Corners lie as far outside as the middles of facets lie inside.
  void add(const Sphere& sphere) {
    const auto stretch = [](int sides) {
      const double c = std::cos(kTurn / 2 / sides);
      return 2 / (1 + c * c);
    };
    int sides = 8;
    while (sides < 96 && sphere.radius * (stretch(sides) - 1) > error_) sides += 4;
    const int bands = sides / 2;
    const double radius = sphere.radius * stretch(sides);
    const auto rim = [&](int band) {
      const double angle = kTurn / 2 * band / bands;
      return Rim(sphere.center - radius * std::cos(angle) * Eigen::Vector3d::UnitZ(),
                 Eigen::Vector3d::UnitZ(), radius * std::sin(angle) / Rim::stretch(sides));
    };
    for (int band = 0; band < bands; ++band) add_band(rim(band), rim(band + 1), sides);
  }

  const Scene& scene_;
  double error_ = 0;
  std::uint16_t paint_ = 0;
  std::map<std::array<std::uint16_t, 3>, std::uint32_t> vertex_at_;
  ColouredSurface surface_;
  PackedModel model_;  // its grid and paints first
};

}  // namespace

PackedModel packed_model(const Scene& scene) {
  if (scene.primitives.empty()) return {};
  return Facets(scene).run();
}

}  // namespace aspect
