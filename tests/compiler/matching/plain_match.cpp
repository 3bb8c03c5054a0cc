#include "tests/compiler/matching/plain_match.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace aspect {
namespace {

using Arcs = std::map<std::pair<std::size_t, std::size_t>, Relation>;

Arcs arcs_of(const ObservedView& view) {
  Arcs arcs;
  for (const Relation& r : view.relations) arcs[{r.from, r.to}] = r;
  return arcs;
}

// By how much the picture of b must turn clockwise to stand as a's would, moved over to b.
double roll(const ObservedView& a, const ObservedView& b) {
  const double angle = std::acos(std::clamp(a.direction.dot(b.direction), -1.0, 1.0));
  const Eigen::Vector3d axis = a.direction.cross(b.direction);
  const Eigen::Vector3d moved =
      axis.norm() < 1e-12 ? a.right
                          : Eigen::Vector3d(Eigen::AngleAxisd(angle, axis.normalized()) * a.right);
  // Seen by b's camera: x along b.right, y along b's down.
  const Eigen::Vector3d down = (-b.direction).cross(b.right);
  return -std::atan2(moved.dot(down), moved.dot(b.right));
}

double squared(double x) {
  return x * x;
}

double node(const ContourFeature& a, const ContourFeature& b, double turn, const MatchScales& s) {
  const auto d = [](float x) { return static_cast<double>(x); };
  double cost = squared((d(a.area) - d(b.area)) / s.area);
  for (std::size_t k = 0; k < 3; ++k) cost += squared((d(a.share[k]) - d(b.share[k])) / s.share);
  const Eigen::Rotation2Dd rotation(turn);
  const Eigen::Vector2d place = rotation * Eigen::Vector2d(d(b.position.x), d(b.position.y));
  cost += squared((d(a.position.x) - place.x()) / s.position);
  cost += squared((d(a.position.y) - place.y()) / s.position);
  Eigen::Matrix2d spread_a, spread_b;
  spread_a << d(a.moments.xx), d(a.moments.xy), d(a.moments.xy), d(a.moments.yy);
  spread_b << d(b.moments.xx), d(b.moments.xy), d(b.moments.xy), d(b.moments.yy);
  const Eigen::Matrix2d matrix = rotation.toRotationMatrix();
  const Eigen::Matrix2d difference =
      d(a.area) * spread_a - d(b.area) * (matrix * spread_b * matrix.transpose());
  return cost + difference.squaredNorm() / squared(s.second);
}

double arc(const Relation& a, const Relation& b, long steps, const MatchScales& s) {
  const double kind = a.kind == b.kind ? 0 : squared(1 / s.kind);
  if (a.kind == Relation::Kind::superimposed || b.kind == Relation::Kind::superimposed) return kind;
  const long apart = ((b.direction + steps - a.direction) % 16 + 16) % 16;
  const double beyond = static_cast<double>(std::max(std::min(apart, 16 - apart) - 1, 0L));
  return kind + squared(beyond / s.direction);
}

double cost_of(const ObservedView& a, const ObservedView& b, const Arcs& arcs_a, const Arcs& arcs_b,
               const MatchScales& scales, const std::vector<std::uint8_t>& mapping) {
  const double turn = roll(a, b);
  const long steps = std::lround(turn * 8 / std::numbers::pi);
  double cost = 0;
  for (std::size_t i = 0; i < a.external_count; ++i)
    cost += node(a.contours[i].feature, b.contours[mapping[i]].feature, turn, scales);
  for (const auto& [ends, relation] : arcs_a) {
    const auto other = arcs_b.find({mapping[ends.first], mapping[ends.second]});
    if (other != arcs_b.end()) cost += arc(relation, other->second, steps, scales);
  }
  return kCostUnit * cost / static_cast<double>(a.external_count);
}

}  // namespace

double plain_cost(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                  const std::vector<std::uint8_t>& mapping) {
  return cost_of(a, b, arcs_of(a), arcs_of(b), scales, mapping);
}

double plain_match_cost(const ObservedView& a, const ObservedView& b, const MatchScales& scales) {
  if (a.external_count == 0 || a.external_count != b.external_count) return kNoMatch;
  const Arcs arcs_a = arcs_of(a), arcs_b = arcs_of(b);
  std::vector<std::uint8_t> mapping(a.external_count);
  std::iota(mapping.begin(), mapping.end(), std::uint8_t{0});
  double least = kNoMatch;
  do {
    least = std::min(least, cost_of(a, b, arcs_a, arcs_b, scales, mapping));
  } while (std::next_permutation(mapping.begin(), mapping.end()));
  return least;
}

}  // namespace aspect
