// Potentials u, v with u[row] + v[column] <= cost everywhere are a lower bound on every
// assignment; the assignment found uses only pairs where they are equal, so it is the least. With
// costs that only rose, the old potentials still obey the first, and the pairs that still obey the
// second are kept: only the other rows have to find a new column, by Dijkstra's shortest path over
// the reduced costs.
#include "compiler/matching/least_assignment.h"

#include <limits>

namespace aspect {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr double kFar = std::numeric_limits<double>::infinity();

struct Solver {
  const AssignmentProblem& problem;
  AssignmentState& state;
  std::vector<std::size_t> row_of, previous;  // by column
  std::vector<double> distance;
  std::vector<bool> done;

  Solver(const AssignmentProblem& the_problem, AssignmentState& the_state)
      : problem(the_problem),
        state(the_state),
        row_of(the_problem.stride, kNone),
        previous(the_problem.stride, kNone),
        distance(the_problem.stride),
        done(the_problem.stride) {}

  // Rows whose old column is still as good as any keep it; the others are left over.
  std::vector<std::size_t> keep_what_holds() {
    std::vector<std::size_t> left_over;
    for (const std::size_t row : problem.rows) {
      double least = kFar;
      std::size_t best = kNone;
      for (const std::size_t column : problem.columns) {
        const double slack =
            problem.costs[row * problem.stride + column] - state.column_potential[column];
        const bool better = slack < least || (slack == least && column == state.column_of[row]);
        if (!better) continue;
        least = slack;
        best = column;
      }
      state.row_potential[row] = least;
      if (row_of[best] == kNone) {
        row_of[best] = row;
        state.column_of[row] = best;
      } else {
        left_over.push_back(row);
      }
    }
    return left_over;
  }

  std::size_t nearest_column() const {
    std::size_t nearest = kNone;
    for (const std::size_t column : problem.columns)
      if (!done[column] && (nearest == kNone || distance[column] < distance[nearest]))
        nearest = column;
    return nearest;
  }

  void relax_from(std::size_t row, std::size_t via, double so_far) {
    for (const std::size_t column : problem.columns) {
      if (done[column]) continue;
      const double there = so_far + state.reduced(problem, row, column);
      if (there >= distance[column]) continue;
      distance[column] = there;
      previous[column] = via;
    }
  }

  void find_column_for(std::size_t row) {
    for (const std::size_t column : problem.columns) {
      distance[column] = kFar;
      done[column] = false;
    }
    relax_from(row, kNone, 0);
    std::size_t end = nearest_column();
    while (row_of[end] != kNone) {
      done[end] = true;
      relax_from(row_of[end], end, distance[end]);
      end = nearest_column();
    }
    const double length = distance[end];
    state.row_potential[row] += length;
    for (const std::size_t column : problem.columns) {
      if (!done[column]) continue;
      state.row_potential[row_of[column]] += length - distance[column];
      state.column_potential[column] -= length - distance[column];
    }
    for (std::size_t column = end; column != kNone; column = previous[column]) {
      const std::size_t before = previous[column];
      row_of[column] = before == kNone ? row : row_of[before];
      state.column_of[row_of[column]] = column;
    }
  }
};

}  // namespace

double assign_least(const AssignmentProblem& problem, AssignmentState& state) {
  Solver solver(problem, state);
  for (const std::size_t row : solver.keep_what_holds()) solver.find_column_for(row);
  double sum = 0;
  for (const std::size_t row : problem.rows)
    sum += problem.costs[row * problem.stride + state.column_of[row]];
  return sum;
}

}  // namespace aspect
