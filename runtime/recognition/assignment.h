// Bipartite matching of at most kMaxSide by kMaxSide, without allocation.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace aspect {

inline constexpr std::size_t kMaxSide = 48;

// For each row the column that it is matched with, or -1.
struct Assignment {
  std::array<std::int16_t, kMaxSide> column_of{};
  int matched = 0;
  double weight = 0;  // sum over the matched pairs
};

// The matching with the largest sum of weights; only pairs with a weight above 0 are matched, so
// rows and columns may stay alone. `weights` is row by row. The Hungarian method with potentials
// (Kuhn 1955, Munkres 1957), O(short side^2 * long side).
void assign(std::span<const double> weights, std::size_t rows, std::size_t columns,
            Assignment& assignment) noexcept;

}  // namespace aspect
