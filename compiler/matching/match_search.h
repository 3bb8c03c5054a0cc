// The search for the best mapping between two graphs whose costs are laid out as matrices.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/vision/view_graph.h"

namespace aspect {

struct Arc {
  bool known = false;  // the graph keeps this arc
  std::uint8_t direction = 0;
  Relation::Kind kind = Relation::Kind::apart;
};

// A quadratic assignment problem: contour i of one graph stands for contour k of the other at
// node_costs[i * count + k], and arc (i, j) for arc (k, l) at arc_cost(i, j, k, l). No cost is
// negative.
struct MatchProblem {
  std::size_t count = 0;
  std::vector<double> node_costs;
  std::vector<Arc> arcs_a, arcs_b;  // count x count
  double kind_cost = 0;             // of arcs of different kinds
  // Of arcs whose directions differ by so many steps of sixteen.
  std::array<double, 9> direction_cost{};

  double arc_cost(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const;

  // Sum over all nodes and all ordered pairs, in a fixed order.
  double cost_of(const std::vector<std::uint8_t>& mapping) const;
};

struct SearchLimits {
  double cost = 0;                   // mappings that cost more are of no interest
  std::size_t steps = 0;             // assignments solved
  std::chrono::nanoseconds time{0};  // 0: none. The only limit that depends on the machine
};

struct FoundMapping {
  std::vector<std::uint8_t> mapping;  // empty: none within limits.cost
  double cost = 0;
  bool gave_up = false;  // a limit was met: there may be a better one
};

FoundMapping search_mapping(const MatchProblem& problem, const SearchLimits& limits);

}  // namespace aspect
