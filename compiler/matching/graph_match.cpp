#include "compiler/matching/graph_match.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "compiler/matching/match_search.h"

namespace aspect {
namespace {

double square(double x) {
  return x * x;
}

// The squared difference of two attributes in steps of `scale`.
double steps(float a, float b, double scale) {
  return square((static_cast<double>(a) - static_cast<double>(b)) / scale);
}

double node_cost(const ContourFeature& a, const ContourFeature& b, const MatchScales& scales) {
  double cost = steps(a.area, b.area, scales.area);
  for (std::size_t channel = 0; channel < 3; ++channel)
    cost += steps(a.share[channel], b.share[channel], scales.share);
  cost += steps(a.position.x, b.position.x, scales.position);
  cost += steps(a.position.y, b.position.y, scales.position);
  const auto second = [&](float p, float q) {
    return steps(p * a.area, q * b.area, scales.second);
  };
  return cost + second(a.moments.xx, b.moments.xx) + 2 * second(a.moments.xy, b.moments.xy) +
         second(a.moments.yy, b.moments.yy);
}

// The angle, clockwise on the screen, by which the picture of b must be turned to stand as a's
// does.
double roll_between(const ObservedView& a, const ObservedView& b) {
  const Eigen::Quaterniond along = Eigen::Quaterniond::FromTwoVectors(a.direction, b.direction);
  const Eigen::Vector3d right = along * a.right;
  // x right, y down, z away from the camera: down = z x right.
  const Eigen::Vector3d down = (-b.direction).cross(right);
  return std::atan2(b.right.dot(down), b.right.dot(right));
}

std::vector<ContourFeature> turned_features(const ObservedView& view, double roll) {
  std::vector<ContourFeature> features;
  const auto c = static_cast<float>(std::cos(roll)), s = static_cast<float>(std::sin(roll));
  for (std::size_t k = 0; k < view.external_count; ++k)
    features.push_back(turned(view.contours[k].feature, c, s));
  return features;
}

// Arcs of a graph as a matrix.
std::vector<Arc> arc_matrix(const ObservedView& view, double roll) {
  std::vector<Arc> arcs(view.external_count * view.external_count);
  // Halves are rounded away from zero whatever their last bits, so that both orders agree.
  const double turns = roll * 8 / std::numbers::pi;
  const long steps = std::lround(turns + std::copysign(1e-9, turns));
  for (const Relation& r : view.relations)
    arcs[r.from * view.external_count + r.to] = {
        true, static_cast<std::uint8_t>((r.direction + steps) & 15), r.kind};
  return arcs;
}

void set_node_costs(const ObservedView& a, const ObservedView& b, double roll,
                    const MatchScales& scales, MatchProblem& problem) {
  const std::vector<ContourFeature> turned_b = turned_features(b, roll);
  problem.count = a.external_count;
  problem.node_costs.reserve(problem.count * problem.count);
  for (std::size_t i = 0; i < problem.count; ++i)
    for (const ContourFeature& other : turned_b)
      problem.node_costs.push_back(node_cost(a.contours[i].feature, other, scales));
}

void set_arcs(const ObservedView& a, const ObservedView& b, double roll, const MatchScales& scales,
              MatchProblem& problem) {
  problem.arcs_a = arc_matrix(a, 0);
  problem.arcs_b = arc_matrix(b, roll);
  problem.kind_cost = square(1 / scales.kind);
  for (std::size_t distance = 2; distance < problem.direction_cost.size(); ++distance)
    problem.direction_cost[distance] =
        square((static_cast<double>(distance) - 1) / scales.direction);
}

// What every mapping costs at least: spares most unlike pairs the search.
double least_cost(const MatchProblem& problem) {
  double sum = 0;
  for (std::size_t i = 0; i < problem.count; ++i) {
    const auto row = problem.node_costs.begin() + static_cast<std::ptrdiff_t>(i * problem.count);
    sum += *std::min_element(row, row + static_cast<std::ptrdiff_t>(problem.count));
  }
  return sum;
}

}  // namespace

GraphMatch match_graphs(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                        const MatchLimits& limits) {
  GraphMatch match;
  const std::size_t n = a.external_count;
  if (n == 0 || n != b.external_count || n > kMostNodes) return match;
  const double unit = kCostUnit / static_cast<double>(n);
  const double roll = roll_between(a, b);
  MatchProblem problem;
  set_node_costs(a, b, roll, scales, problem);
  if (least_cost(problem) > limits.cost / unit) return match;
  set_arcs(a, b, roll, scales, problem);
  FoundMapping found = search_mapping(problem, {limits.cost / unit, limits.steps, limits.time});
  match.gave_up = found.gave_up;
  if (found.mapping.empty()) return match;
  match.cost = found.cost * unit;
  match.mapping = std::move(found.mapping);
  return match;
}

double mapping_cost(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                    const std::vector<std::uint8_t>& mapping) {
  const double roll = roll_between(a, b);
  MatchProblem problem;
  set_node_costs(a, b, roll, scales, problem);
  set_arcs(a, b, roll, scales, problem);
  return problem.cost_of(mapping) * kCostUnit / static_cast<double>(problem.count);
}

GraphMatch reversed(const GraphMatch& match) {
  GraphMatch back = match;
  for (std::size_t i = 0; i < match.mapping.size(); ++i)
    back.mapping[match.mapping[i]] = static_cast<std::uint8_t>(i);
  return back;
}

}  // namespace aspect
