#include "runtime/recognition/assignment.h"

#include <algorithm>
#include <limits>

#include "runtime/base/check.h"

namespace aspect {
namespace {

// Rows and columns are counted from 1 here; 0 stands for "none" as in the usual formulation with
// potentials. Columns beyond the real ones are dummies of weight 0: a row matched there is alone.
struct Solver {
  std::span<const double> weights;
  std::size_t rows, columns, all_columns;
  std::array<double, kMaxSide + 1> row_potential{};
  std::array<double, 2 * kMaxSide + 1> column_potential{}, least{};
  std::array<std::size_t, 2 * kMaxSide + 1> row_of{}, previous{};
  std::array<bool, 2 * kMaxSide + 1> used{};

  double cost(std::size_t row, std::size_t column) const {
    if (column > columns) return 0;
    return -std::max(weights[(row - 1) * columns + column - 1], 0.0);
  }

  // Finds the cheapest alternating path from an unmatched row to an unmatched column.
  void augment(std::size_t row) {
    row_of[0] = row;
    std::fill_n(least.begin(), all_columns + 1, std::numeric_limits<double>::infinity());
    std::fill_n(used.begin(), all_columns + 1, false);
    std::size_t column = 0;
    do {
      used[column] = true;
      const std::size_t from = row_of[column];
      double step = std::numeric_limits<double>::infinity();
      std::size_t next = 0;
      for (std::size_t k = 1; k <= all_columns; ++k) {
        if (used[k]) continue;
        const double reduced = cost(from, k) - row_potential[from] - column_potential[k];
        if (reduced < least[k]) {
          least[k] = reduced;
          previous[k] = column;
        }
        if (least[k] < step) {
          step = least[k];
          next = k;
        }
      }
      for (std::size_t k = 0; k <= all_columns; ++k) {
        if (used[k]) {
          row_potential[row_of[k]] += step;
          column_potential[k] -= step;
        } else {
          least[k] -= step;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    for (; column != 0; column = previous[column]) row_of[column] = row_of[previous[column]];
  }
};

}  // namespace

void assign(std::span<const double> weights, std::size_t rows, std::size_t columns,
            Assignment& assignment) noexcept {
  ASPECT_DCHECK(rows <= kMaxSide && columns <= kMaxSide && weights.size() >= rows * columns);
  Solver solver{weights, rows, columns, columns + rows, {}, {}, {}, {}, {}, {}};
  for (std::size_t row = 1; row <= rows; ++row) solver.augment(row);
  std::fill_n(assignment.column_of.begin(), rows, std::int16_t{-1});
  assignment.matched = 0;
  assignment.weight = 0;
  for (std::size_t column = 1; column <= columns; ++column) {
    const std::size_t row = solver.row_of[column];
    if (row == 0) continue;
    const double weight = weights[(row - 1) * columns + column - 1];
    if (!(weight > 0)) continue;
    assignment.column_of[row - 1] = static_cast<std::int16_t>(column - 1);
    ++assignment.matched;
    assignment.weight += weight;
  }
}

}  // namespace aspect
