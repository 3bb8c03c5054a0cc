// The one-to-one assignment of rows to columns with the least sum of costs, and the proof of it.
#pragma once

#include <cstddef>
#include <vector>

namespace aspect {

// A square matrix of costs of which some rows and columns are in play.
struct AssignmentProblem {
  std::size_t stride = 0;
  const double* costs = nullptr;         // row by row, none negative
  const std::vector<std::size_t>& rows;  // in play; as many as columns
  const std::vector<std::size_t>& columns;
};

// Kept between problems: potentials that were right for lower costs, or for more rows and columns,
// are where the next solution starts from. All zero at first.
struct AssignmentState {
  std::vector<double> row_potential, column_potential;  // by row, by column
  std::vector<std::size_t> column_of;                   // by row; of rows in play

  explicit AssignmentState(std::size_t side)
      : row_potential(side, 0), column_potential(side, 0), column_of(side, 0) {}

  // How much dearer the assignment gets, at least, with this row in this column.
  double reduced(const AssignmentProblem& problem, std::size_t row, std::size_t column) const {
    return problem.costs[row * problem.stride + column] - row_potential[row] -
           column_potential[column];
  }
};

// Least sum of costs. The Hungarian method with shortest augmenting paths (Jonker and Volgenant
// 1987). O(rows^3) from nothing, O(rows^2) for each row whose costs rose.
double assign_least(const AssignmentProblem& problem, AssignmentState& state);

}  // namespace aspect
