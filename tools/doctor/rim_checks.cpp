#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "compiler/scene/ear_clipping.h"
#include "tools/doctor/topology_checks.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kClose = 1e-6;  // of the rim's own size
constexpr double kRound = 2 * std::numbers::pi;

struct Rim {
  Vector3d center, normal;
  double radius = 0;
  std::size_t primitive = 0;
};

std::vector<Rim> rims_of(const Scene& scene) {
  std::vector<Rim> rims;
  const auto add = [&](const Vector3d& center, const Vector3d& normal, double radius,
                       std::size_t primitive) {
    if (radius > 0) rims.push_back({center, normal, radius, primitive});
  };
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    if (const auto* ring = std::get_if<Ring>(&scene.primitives[k].shape)) {
      add(ring->center, ring->normal, ring->min_radius, k);
      add(ring->center, ring->normal, ring->max_radius, k);
    }
    if (const auto* cone = std::get_if<Cone>(&scene.primitives[k].shape)) {
      const Vector3d axis = (cone->apex - cone->base).normalized();
      add(cone->base, axis, cone->base_radius, k);
      add(cone->apex, axis, cone->apex_radius, k);
    }
  }
  return rims;
}

bool is_same(const Rim& a, const Rim& b) {
  const double close = kClose * a.radius;
  return a.primitive != b.primitive && (a.center - b.center).norm() <= 2 * close &&
         std::abs(a.radius - b.radius) <= close && a.normal.cross(b.normal).norm() <= 1e-6;
}

// By the sum of the angles under which the polygon's edges are seen.
bool contains(const Polygon& polygon, const Vector3d& normal, const Vector3d& point) {
  double angle = 0;
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    const Vector3d a = polygon.vertices[k] - point;
    const Vector3d b = polygon.vertices[(k + 1) % polygon.vertices.size()] - point;
    angle += std::atan2(normal.dot(a.cross(b)), a.dot(b));
  }
  return std::abs(angle) > kRound / 2;
}

bool bears(const Primitive& primitive, const Rim& rim) {
  const double close = 4 * kClose * rim.radius;
  Vector3d normal = Vector3d::Zero(), origin = Vector3d::Zero();
  const auto* polygon = std::get_if<Polygon>(&primitive.shape);
  const auto* ring = std::get_if<Ring>(&primitive.shape);
  if (polygon != nullptr) {
    normal = polygon_normal(polygon->vertices);
    origin = polygon->vertices.front();
  } else if (ring != nullptr) {
    normal = ring->normal;
    origin = ring->center;
  } else {
    return false;
  }
  const Vector3d u = rim.normal.unitOrthogonal(), v = rim.normal.cross(u);
  constexpr int kSamples = 16;
  for (int k = 0; k < kSamples; ++k) {
    const double angle = kRound * (k + 0.5) / kSamples;
    const Vector3d point = rim.center + rim.radius * (std::cos(angle) * u + std::sin(angle) * v);
    if (std::abs(normal.dot(point - origin)) > close) return false;
    if (polygon != nullptr && !contains(*polygon, normal, point)) return false;
    const double reach = (point - origin).norm();
    if (ring != nullptr && (reach < ring->min_radius - close || reach > ring->max_radius + close))
      return false;
  }
  return true;
}

void mark(const Rim& rim, FindingMarks& marks) {
  constexpr int kSides = 48;
  if (marks.lines.size() + kSides > FindingMarks::kMost) return;
  const Vector3d u = rim.radius * rim.normal.unitOrthogonal(), v = rim.normal.cross(u);
  const auto at = [&](int side) {
    const double angle = kRound * side / kSides;
    return Vector3d(rim.center + std::cos(angle) * u + std::sin(angle) * v);
  };
  for (int side = 0; side < kSides; ++side) marks.lines.push_back({at(side), at(side + 1)});
}

}  // namespace

std::vector<Finding> check_rims(const Scene& scene) {
  const std::vector<Rim> rims = rims_of(scene);
  constexpr double kMostWork = 3e7;  // hostile scenes alone have as many
  const double all = static_cast<double>(rims.size() + scene.primitives.size());
  if (static_cast<double>(rims.size()) * all > kMostWork) return {};
  Finding open{"topology",
               "open_rims",
               Severity::warning,
               "",
               "close them with rings of the same radius, or set them on a face",
               0,
               {},
               false};
  for (const Rim& rim : rims) {
    bool closed = false;
    for (const Rim& other : rims) closed = closed || is_same(rim, other);
    for (std::size_t k = 0; k < scene.primitives.size() && !closed; ++k)
      closed = k != rim.primitive && bears(scene.primitives[k], rim);
    if (closed) continue;
    ++open.count;
    if (open.where.size() < Finding::kMostPlaces) open.where.push_back(rim.primitive + 1);
    mark(rim, open.marks);
  }
  if (open.count == 0) return {};
  open.message = fmt::format(
      "open rims of cones and rings, through which the inside can be seen: {}", open.count);
  return {open};
}

}  // namespace aspect
