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
  std::size_t row_step, column_step;  // the solver's rows may be the caller's columns
  std::size_t rows, columns, all_columns;
  std::array<double, kMaxSide + 1> row_potential{};
  std::array<double, 2 * kMaxSide + 1> column_potential{}, least{};
  std::array<std::size_t, 2 * kMaxSide + 1> row_of{}, previous{};
  std::array<bool, 2 * kMaxSide + 1> used{};

  double cost(std::size_t row, std::size_t column) const {
    if (column > columns) return 0;
    return -std::max(weights[(row - 1) * row_step + (column - 1) * column_step], 0.0);
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

// The usual case: every row has one column that it fits best, and no two have the same. Then no
// other assignment weighs as much. False where it is not so.
bool take_best(std::span<const double> weights, std::size_t rows, std::size_t columns,
               Assignment& assignment) {
  std::array<bool, kMaxSide> taken{};
  for (std::size_t row = 0; row < rows; ++row) {
    const std::span<const double> here = weights.subspan(row * columns, columns);
    double best = 0;
    std::size_t place = columns;
    bool tied = false;
    for (std::size_t k = 0; k < columns; ++k) {
      if (!(here[k] >= best)) continue;
      tied = here[k] == best && best > 0;
      if (here[k] == best) continue;
      best = here[k];
      place = k;
    }
    if (tied || (place < columns && taken[place])) return false;
    assignment.column_of[row] = -1;
    if (place == columns) continue;
    assignment.column_of[row] = static_cast<std::int16_t>(place);
    taken[place] = true;
  }
  return true;
}

void solve(std::span<const double> weights, std::size_t rows, std::size_t columns,
           Assignment& assignment) {
  // Each row costs a search over all columns, so the shorter side makes the rows.
  const bool turned = columns < rows;
  const std::size_t short_side = std::min(rows, columns), long_side = std::max(rows, columns);
  Solver solver{weights,
                turned ? 1 : columns,
                turned ? columns : 1,
                short_side,
                long_side,
                long_side + short_side,
                {},
                {},
                {},
                {},
                {},
                {}};
  for (std::size_t row = 1; row <= short_side; ++row) solver.augment(row);
  std::fill_n(assignment.column_of.begin(), rows, std::int16_t{-1});
  for (std::size_t k = 1; k <= long_side; ++k) {
    if (solver.row_of[k] == 0) continue;
    const std::size_t row = (turned ? k : solver.row_of[k]) - 1;
    const std::size_t column = (turned ? solver.row_of[k] : k) - 1;
    if (weights[row * columns + column] > 0)
      assignment.column_of[row] = static_cast<std::int16_t>(column);
  }
}

}  // namespace

void assign(std::span<const double> weights, std::size_t rows, std::size_t columns,
            Assignment& assignment) noexcept {
  ASPECT_DCHECK(rows <= kMaxSide && columns <= kMaxSide && weights.size() >= rows * columns);
  if (!take_best(weights, rows, columns, assignment)) solve(weights, rows, columns, assignment);
  assignment.matched = 0;
  assignment.weight = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    if (assignment.column_of[row] < 0) continue;
    ++assignment.matched;
    assignment.weight +=
        weights[row * columns + static_cast<std::size_t>(assignment.column_of[row])];
  }
}

}  // namespace aspect
