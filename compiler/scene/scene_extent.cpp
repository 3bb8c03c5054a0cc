// Every primitive lies in the convex hull of its corners, rims and spheres, so the farthest two
// points of a scene lie on those. Two of them are compared only if their distances from the box's
// centre add up to more than the best so far.
#include "compiler/scene/scene_extent.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

namespace aspect {
namespace {

// A corner, a rim (radius about a unit normal) or a ball.
struct Hull {
  enum class Kind { corner, rim, ball } kind = Kind::corner;
  Eigen::Vector3d center;
  Eigen::Vector3d normal{0, 0, 0};
  double radius = 0;
};

struct HullParts {
  std::vector<Hull>& parts;

  void add_corners(std::span<const Eigen::Vector3d> corners) const {
    for (const Eigen::Vector3d& corner : corners) parts.push_back({Hull::Kind::corner, corner});
  }
  void operator()(const Polygon& polygon) const { add_corners(polygon.vertices); }
  void operator()(const Mesh& mesh) const { add_corners(mesh.vertices); }
  void operator()(const SmoothTriangle& triangle) const { add_corners(triangle.vertices); }
  void operator()(const Sphere& sphere) const {
    parts.push_back({Hull::Kind::ball, sphere.center, {0, 0, 0}, sphere.radius});
  }
  void operator()(const Ring& ring) const {
    parts.push_back({Hull::Kind::rim, ring.center, ring.normal, ring.max_radius});
  }
  void operator()(const Cone& cone) const {
    const Eigen::Vector3d axis = (cone.apex - cone.base).normalized();
    parts.push_back({Hull::Kind::rim, cone.base, axis, cone.base_radius});
    parts.push_back({Hull::Kind::rim, cone.apex, axis, cone.apex_radius});
  }
};

// Half the size of its box.
Eigen::Vector3d half_box(const Hull& part) {
  if (part.kind == Hull::Kind::ball) return Eigen::Vector3d::Constant(part.radius);
  if (part.kind == Hull::Kind::corner) return Eigen::Vector3d::Zero();
  return part.radius * (1 - part.normal.array().square()).max(0).sqrt().matrix();
}

double farthest(const Hull& part, const Eigen::Vector3d& from) {
  const Eigen::Vector3d offset = part.center - from;
  if (part.kind != Hull::Kind::rim) return offset.norm() + part.radius;
  const double along = offset.dot(part.normal);
  const double across = (offset - along * part.normal).norm();
  return std::hypot(along, across + part.radius);
}

// The farthest point of `b` from a point that goes round `a`: sampled, then the best stretch is cut
// down by golden sections.
double farthest_from_rim(const Hull& a, const Hull& b) {
  constexpr int kSamples = 90;
  const Eigen::Vector3d u = a.radius * a.normal.unitOrthogonal();
  const Eigen::Vector3d v = a.normal.cross(u);
  const auto reach = [&](double angle) {
    return farthest(b, a.center + std::cos(angle) * u + std::sin(angle) * v);
  };
  constexpr double kStep = 2 * std::numbers::pi / kSamples;
  double best = 0, best_angle = 0;
  for (int k = 0; k < kSamples; ++k) {
    const double found = reach(k * kStep);
    if (found <= best) continue;
    best = found;
    best_angle = k * kStep;
  }
  double low = best_angle - kStep, high = best_angle + kStep;
  for (int k = 0; k < 40; ++k) {
    const double third = (high - low) / (std::numbers::phi + 1);
    if (reach(low + third) < reach(high - third))
      low += third;
    else
      high -= third;
  }
  return std::max(best, reach((low + high) / 2));
}

double distance(const Hull& a, const Hull& b) {
  if (a.kind == Hull::Kind::rim && b.kind == Hull::Kind::rim) return farthest_from_rim(a, b);
  if (a.kind == Hull::Kind::rim) return farthest(a, b.center) + b.radius;
  return farthest(b, a.center) + a.radius;
}

double diameter_of(const std::vector<Hull>& parts, const Eigen::Vector3d& centre) {
  std::vector<std::pair<double, const Hull*>> by_reach;
  for (const Hull& part : parts) by_reach.emplace_back(farthest(part, centre), &part);
  std::stable_sort(by_reach.begin(), by_reach.end(),
                   [](const auto& p, const auto& q) { return p.first > q.first; });
  double best = 0;
  for (std::size_t i = 0; i < by_reach.size() && 2 * by_reach[i].first > best; ++i) {
    best = std::max(best, 2 * by_reach[i].second->radius);
    for (std::size_t k = i + 1; k < by_reach.size(); ++k) {
      if (by_reach[i].first + by_reach[k].first <= best) break;
      best = std::max(best, distance(*by_reach[i].second, *by_reach[k].second));
    }
  }
  return best;
}

// A corner of many faces counts once.
void drop_repeated_corners(std::vector<Hull>& parts) {
  const auto key = [](const Hull& h) {
    return std::tuple(h.kind, h.center.x(), h.center.y(), h.center.z());
  };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const Hull& a, const Hull& b) { return key(a) < key(b); });
  const auto same = [&](const Hull& a, const Hull& b) {
    return a.kind == Hull::Kind::corner && key(a) == key(b);
  };
  parts.erase(std::unique(parts.begin(), parts.end(), same), parts.end());
}

}  // namespace

SceneExtent scene_extent(const Scene& scene) {
  std::vector<Hull> parts;
  for (const Primitive& primitive : scene.primitives) std::visit(HullParts{parts}, primitive.shape);
  SceneExtent extent;
  if (parts.empty()) return extent;
  extent.least.setConstant(std::numeric_limits<double>::infinity());
  extent.most = -extent.least;
  for (const Hull& part : parts) {
    extent.least = extent.least.cwiseMin(part.center - half_box(part));
    extent.most = extent.most.cwiseMax(part.center + half_box(part));
  }
  drop_repeated_corners(parts);
  extent.diameter = diameter_of(parts, (extent.least + extent.most) / 2);
  return extent;
}

}  // namespace aspect
