// Graph matching as graph_match.h describes it, written for being read: every permutation, and the
// cost of one straight from the definitions. The reference that the fast search is held against.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/matching/graph_match.h"

namespace aspect {

double plain_cost(const ObservedView& a, const ObservedView& b, const MatchScales& scales,
                  const std::vector<std::uint8_t>& mapping);

// The least cost of all mappings, kNoMatch where there is none. O(n! n^2).
double plain_match_cost(const ObservedView& a, const ObservedView& b, const MatchScales& scales);

}  // namespace aspect
