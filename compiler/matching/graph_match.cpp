#include "compiler/matching/graph_match.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "runtime/vision/relations.h"

namespace aspect {
namespace {

// Partial mappings tried before a search is cut short: far more than any pair of views of the
// thesis's objects needs, so that only a graph of many equal contours ever meets it.
constexpr std::size_t kMostTried = 20000;

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

// Arcs of a graph as a matrix; `known` is false where the graph does not keep the arc.
struct Arc {
  bool known = false;
  std::uint8_t direction = 0;
  Relation::Kind kind = Relation::Kind::apart;
};

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

double arc_cost(const Arc& a, const Arc& b, const MatchScales& scales) {
  if (!a.known || !b.known) return 0;
  double cost = a.kind == b.kind ? 0 : square(1 / scales.kind);
  const bool directed =
      a.kind != Relation::Kind::superimposed && b.kind != Relation::Kind::superimposed;
  if (directed)
    cost +=
        square(std::max(direction_distance(a.direction, b.direction) - 1, 0) / scales.direction);
  return cost;
}

struct Search {
  std::size_t n;
  std::vector<double> nodes;  // n x n
  std::vector<Arc> arcs_a, arcs_b;
  const MatchScales& scales;
  std::vector<std::size_t> order;  // contours of a, the most particular first
  std::vector<double> least_from;  // least cost of the contours from a place in the order on
  std::vector<std::uint8_t> mapping, best_mapping;
  std::vector<bool> used;
  double best;
  std::size_t tried = 0;

  Search(const ObservedView& a, const ObservedView& b, const MatchScales& match_scales,
         double limit)
      : n(a.external_count),
        nodes(n * n),
        arcs_a(arc_matrix(a, 0)),
        arcs_b(arc_matrix(b, roll_between(a, b))),
        scales(match_scales),
        order(n),
        least_from(n + 1, 0),
        mapping(n),
        used(n, false),
        best(limit) {
    const std::vector<ContourFeature> turned_b = turned_features(b, roll_between(a, b));
    std::vector<double> least(n, kNoMatch);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        nodes[i * n + k] = node_cost(a.contours[i].feature, turned_b[k], scales);
        least[i] = std::min(least[i], nodes[i * n + k]);
      }
    }
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
      return a.contours[p].feature.area > a.contours[q].feature.area;
    });
    for (std::size_t place = n; place-- > 0;)
      least_from[place] = least_from[place + 1] + least[order[place]];
  }

  double step_cost(std::size_t place, std::size_t k) const {
    const std::size_t i = order[place];
    double cost = nodes[i * n + k];
    for (std::size_t earlier = 0; earlier < place; ++earlier) {
      const std::size_t j = order[earlier], l = mapping[j];
      cost += arc_cost(arcs_a[i * n + j], arcs_b[k * n + l], scales) +
              arc_cost(arcs_a[j * n + i], arcs_b[l * n + k], scales);
    }
    return cost;
  }

  void extend(std::size_t place, double cost) {
    if (place == n) {
      best = cost;
      best_mapping = mapping;
      return;
    }
    const std::size_t i = order[place];
    std::vector<std::pair<double, std::size_t>> choices;
    for (std::size_t k = 0; k < n; ++k)
      if (!used[k]) choices.emplace_back(step_cost(place, k), k);
    std::sort(choices.begin(), choices.end());
    for (const auto& [step, k] : choices) {
      if (++tried > kMostTried) return;
      const double bound = cost + step + least_from[place + 1];
      if (bound > best || (bound == best && !best_mapping.empty())) return;
      mapping[i] = static_cast<std::uint8_t>(k);
      used[k] = true;
      extend(place + 1, cost + step);
      used[k] = false;
    }
  }
};

}  // namespace

GraphMatch match_graphs(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                        double give_up) {
  GraphMatch match;
  const std::size_t n = a.external_count;
  if (n == 0 || n != b.external_count || n > 255) return match;
  const double unit = kCostUnit / static_cast<double>(n);
  Search search(a, b, scales, give_up / unit);
  search.extend(0, 0);
  match.gave_up = search.tried > kMostTried;
  if (search.best_mapping.empty()) return match;
  match.cost = search.best * unit;
  match.mapping = search.best_mapping;
  return match;
}

double mapping_cost(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                    const std::vector<std::uint8_t>& mapping) {
  const std::size_t n = a.external_count;
  const double roll = roll_between(a, b);
  const std::vector<ContourFeature> turned_b = turned_features(b, roll);
  const std::vector<Arc> arcs_a = arc_matrix(a, 0), arcs_b = arc_matrix(b, roll);
  double cost = 0;
  for (std::size_t i = 0; i < n; ++i) {
    cost += node_cost(a.contours[i].feature, turned_b[mapping[i]], scales);
    for (std::size_t j = 0; j < n; ++j)
      if (i != j) cost += arc_cost(arcs_a[i * n + j], arcs_b[mapping[i] * n + mapping[j]], scales);
  }
  return cost * kCostUnit / static_cast<double>(n);
}

GraphMatch reversed(const GraphMatch& match) {
  GraphMatch back = match;
  for (std::size_t i = 0; i < match.mapping.size(); ++i)
    back.mapping[match.mapping[i]] = static_cast<std::uint8_t>(i);
  return back;
}

}  // namespace aspect
