// Inexact matching of two views' attributed relational graphs (thesis 3.3.2): the one-to-one
// mapping of external contours with the least cost, and that cost.
//
// Where we deviate: the second picture is first turned by the roll that its camera has against the
// first one's moved over on the great circle, so that the poles, around which an upright camera
// spins, are places like any other.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <vector>

#include "compiler/matching/observed_view.h"

namespace aspect {

// Differences that cost as much as one; a cost is the sum of their squares over nodes and arcs,
// divided by the number of nodes and times kCostUnit. So kCostUnit is the cost of two views that
// differ by one such step in every contour.
struct MatchScales {
  double share = 0.05;     // colour share
  double area = 0.15;      // share of the outline's area
  double position = 0.25;  // square roots of the outline's area
  double second = 0.05;    // second moments, in the outline's area
  double direction = 3;    // steps of the 16-way direction beyond the first, per arc
  double kind = 1;         // inside against outside and so on, per arc
};

inline constexpr double kCostUnit = 10000;
inline constexpr double kNoMatch = std::numeric_limits<double>::infinity();

inline constexpr std::size_t kMostNodes = 255;

struct MatchLimits {
  double cost = kCostUnit;           // dearer mappings are of no interest
  std::size_t steps = 2000;          // of the search: far more than views of real objects need
  std::chrono::nanoseconds time{0};  // of a match, 0: any. Makes results depend on the machine
};

struct GraphMatch {
  double cost = kNoMatch;             // kNoMatch: different node counts, or above the limit
  std::vector<std::uint8_t> mapping;  // external contour of the first -> of the second
  bool gave_up = false;               // the search was cut short; counted in the statistics
};

// The true optimum, if its cost is within the limit: see match_search.h.
GraphMatch match_graphs(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                        const MatchLimits& limits);

// The cost of a given mapping: what match_graphs minimises.
double mapping_cost(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                    const std::vector<std::uint8_t>& mapping);

// The same match seen from the other graph.
GraphMatch reversed(const GraphMatch& match);

}  // namespace aspect
