#include "tests/tools/eval/object_rotations.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace aspect {
namespace {

// Scenes are written with about six decimals.
constexpr double kLength = 1e-5;  // of the object's radius
constexpr double kColour = 1.0 / 255;
// Bounds the work where there are products of turns by any angle.
constexpr std::size_t kMostRotations = 2048;

struct Comparison {
  const Scene& scene;
  Eigen::Matrix3d rotation;
  double tolerance;

  Eigen::Vector3d turned(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d& centre = scene.studio.at;
    return centre + rotation * (point - centre);
  }
  bool near(double a, double b) const { return std::abs(a - b) <= tolerance; }
  bool near(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return (turned(from) - to).cwiseAbs().maxCoeff() <= tolerance;
  }

  bool alike(const Polygon& a, const Polygon& b) const {
    const std::size_t count = a.vertices.size();
    if (b.vertices.size() != count) return false;
    for (std::size_t start = 0; start < count; ++start)
      for (const std::size_t step : {std::size_t{1}, count - 1}) {
        std::size_t k = 0;
        while (k < count && near(a.vertices[k], b.vertices[(start + k * step) % count])) ++k;
        if (k == count) return true;
      }
    return false;
  }
  bool alike(const SmoothTriangle& a, const SmoothTriangle& b) const {
    std::array<std::size_t, 3> order = {0, 1, 2};
    do {
      std::size_t k = 0;
      while (k < 3 && near(a.vertices[k], b.vertices[order[k]]) &&
             (rotation * a.normals[k] - b.normals[order[k]]).norm() <= kLength)
        ++k;
      if (k == 3) return true;
    } while (std::next_permutation(order.begin(), order.end()));
    return false;
  }
  bool alike(const Sphere& a, const Sphere& b) const {
    return near(a.radius, b.radius) && near(a.center, b.center);
  }
  bool alike(const Ring& a, const Ring& b) const {
    const Eigen::Vector3d normal = rotation * a.normal;
    return near(a.min_radius, b.min_radius) && near(a.max_radius, b.max_radius) &&
           near(a.center, b.center) &&
           std::min((normal - b.normal).norm(), (normal + b.normal).norm()) <= kLength;
  }
  bool alike(const Cone& a, const Cone& b) const {
    const bool same = near(a.base, b.base) && near(a.apex, b.apex) &&
                      near(a.base_radius, b.base_radius) && near(a.apex_radius, b.apex_radius);
    const bool swapped = near(a.base, b.apex) && near(a.apex, b.base) &&
                         near(a.base_radius, b.apex_radius) && near(a.apex_radius, b.base_radius);
    return same || swapped;
  }
  // By their vertices alone, since equal surfaces may be cut into triangles differently.
  bool alike(const Mesh& a, const Mesh& b) const {
    if (a.vertices.size() != b.vertices.size()) return false;
    if (!near(middle(a), middle(b))) return false;
    std::vector<Eigen::Vector3d> sorted = b.vertices;
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& p, const auto& q) { return p.x() < q.x(); });
    return std::all_of(a.vertices.begin(), a.vertices.end(), [&](const Eigen::Vector3d& from) {
      const double least = turned(from).x() - tolerance;
      auto to = std::lower_bound(sorted.begin(), sorted.end(), least,
                                 [](const auto& p, double x) { return p.x() < x; });
      while (to != sorted.end() && to->x() <= least + 2 * tolerance && !near(from, *to)) ++to;
      return to != sorted.end() && near(from, *to);
    });
  }
  static Eigen::Vector3d middle(const Mesh& mesh) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& vertex : mesh.vertices) sum += vertex;
    return sum / static_cast<double>(mesh.vertices.size());
  }
  template <typename A, typename B>
  bool alike(const A&, const B&) const {
    return false;
  }

  bool same_colour(int a, int b) const {
    const Surface& first = scene.surfaces[static_cast<std::size_t>(a)];
    const Surface& other = scene.surfaces[static_cast<std::size_t>(b)];
    const auto near_colour = [](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
      return (x - y).cwiseAbs().maxCoeff() <= kColour;
    };
    // A pattern does not turn with the object.
    if (first.texture != nullptr || other.texture != nullptr)
      return a == b && rotation.isIdentity(kLength);
    // Without lights only ambient light shows a surface's colour.
    return near_colour(first.ambient, other.ambient) &&
           near_colour(first.specular, other.specular) &&
           near_colour(first.transparent, other.transparent) &&
           (scene.lights.empty() || near_colour(first.diffuse, other.diffuse));
  }

  bool onto_itself() const {
    std::vector<bool> taken(scene.primitives.size(), false);
    return std::all_of(
        scene.primitives.begin(), scene.primitives.end(), [&](const Primitive& from) {
          for (std::size_t k = 0; k < taken.size(); ++k) {
            const Primitive& to = scene.primitives[k];
            if (taken[k] || !same_colour(from.surface, to.surface)) continue;
            if (!std::visit([&](const auto& a, const auto& b) { return alike(a, b); }, from.shape,
                            to.shape))
              continue;
            taken[k] = true;
            return true;
          }
          return false;
        });
  }
};

// A set of rotations in which each is found again in spite of rounding.
class RotationSet {
 public:
  bool add(const Eigen::Matrix3d& rotation) {
    std::array<int, 9> key{};
    for (Eigen::Index k = 0; k < 9; ++k)
      key[static_cast<std::size_t>(k)] =
          static_cast<int>(std::lround(1e4 * rotation(k / 3, k % 3)));
    if (!keys_.insert(key).second) return false;
    rotations.push_back(rotation);
    return true;
  }
  std::vector<Eigen::Matrix3d> rotations;

 private:
  std::set<std::array<int, 9>> keys_;
};

void add_cube_rotations(RotationSet& candidates) {
  std::array<Eigen::Index, 3> axes = {0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
      for (unsigned k = 0; k < 3; ++k) rotation(k, axes[k]) = (signs >> k & 1U) == 0 ? 1 : -1;
      if (rotation.determinant() > 0) candidates.add(rotation);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
}

void add_turns(int fold, RotationSet& candidates) {
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (int k = 1; k < fold; ++k)
      candidates.add(Eigen::AngleAxisd(2 * std::numbers::pi * k / fold,
                                       Eigen::Vector3d(Eigen::Vector3d::Unit(axis)))
                         .toRotationMatrix());
}

double radius_about(const Scene& scene) {
  return bounding_radius(scene) + scene.studio.at.norm();
}

}  // namespace

std::vector<Eigen::Matrix3d> object_rotations(const Scene& scene) {
  RotationSet candidates;
  candidates.add(Eigen::Matrix3d::Identity());
  add_cube_rotations(candidates);
  for (const int fold : {2, 3, 5, 6, 8, 12, 360}) add_turns(fold, candidates);
  RotationSet found;
  const double tolerance = kLength * radius_about(scene);
  for (const Eigen::Matrix3d& rotation : candidates.rotations)
    if (Comparison{scene, rotation, tolerance}.onto_itself()) found.add(rotation);
  const std::size_t generators = found.rotations.size();
  for (std::size_t a = 0; a < generators; ++a)
    for (std::size_t b = 0; b < generators && found.rotations.size() < kMostRotations; ++b)
      found.add(found.rotations[a] * found.rotations[b]);
  return found.rotations;
}

}  // namespace aspect
