// Branch and bound. What is decided already is folded into the costs of what is open: an open pair
// (j, l) costs its nodes' difference plus its arcs' to all decided pairs. The least assignment of
// the open pairs is then a bound that no completion can undercut, and itself a completion: where
// the arcs between its own pairs cost nothing, it is the best one and the branch is closed.
// Otherwise the row with the fewest columns that could still lead to a better mapping (by the
// reduced costs of the assignment) is decided; a row with one such column costs no branch.
// Weak side: arcs among open pairs do not raise the bound, so that graphs of many contours that
// differ in their arcs only are searched through.
#include "compiler/matching/match_search.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "compiler/matching/least_assignment.h"
#include "runtime/vision/relations.h"

namespace aspect {
namespace {

// Sums of the same numbers in another order differ by less than this share of them.
constexpr double kRounding = 1e-11;

struct Branch {
  std::vector<double> costs;  // of open pairs, arcs to decided pairs included
  std::vector<std::size_t> rows, columns;
  std::vector<std::uint8_t> mapping;  // of decided rows
  double decided = 0;
  AssignmentState assignment;

  explicit Branch(const MatchProblem& problem)
      : costs(problem.node_costs),
        rows(problem.count),
        columns(problem.count),
        mapping(problem.count),
        assignment(problem.count) {
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    columns = rows;
  }
};

class Search {
 public:
  Search(const MatchProblem& problem, const SearchLimits& limits)
      : problem_(problem), limits_(limits), start_(std::chrono::steady_clock::now()) {
    worst_ = limits.cost * (1 + kRounding);
  }

  FoundMapping run() {
    explore(Branch(problem_));
    return std::move(found_);
  }

 private:
  struct Choice {
    std::size_t row = 0;
    std::vector<std::pair<double, std::size_t>> columns;  // by how much dearer, at least
  };

  bool out_of_patience() {
    if (++steps_ > limits_.steps) found_.gave_up = true;
    if (limits_.time.count() > 0 && std::chrono::steady_clock::now() - start_ > limits_.time)
      found_.gave_up = true;
    return found_.gave_up;
  }

  void explore(Branch branch) {
    for (;;) {
      if (out_of_patience()) return;
      const AssignmentProblem open{problem_.count, branch.costs.data(), branch.rows,
                                   branch.columns};
      const double bound = branch.decided + assign_least(open, branch.assignment);
      if (bound > worst_) return;
      if (offer(branch) <= bound + kRounding * bound) return;
      const Choice choice = choose(branch, open, worst_ - bound);
      if (choice.columns.empty()) return;
      if (choice.columns.size() > 1) return explore_each(branch, choice, bound);
      decide(branch, choice.row, choice.columns.front().second);
    }
  }

  void explore_each(const Branch& branch, const Choice& choice, double bound) {
    for (const auto& [dearer, column] : choice.columns) {
      if (found_.gave_up || bound + dearer > worst_) return;
      Branch child = branch;
      decide(child, choice.row, column);
      explore(std::move(child));
    }
  }

  // The assignment as a whole mapping: what it really costs.
  double offer(const Branch& branch) {
    std::vector<std::uint8_t> mapping = branch.mapping;
    for (const std::size_t row : branch.rows)
      mapping[row] = static_cast<std::uint8_t>(branch.assignment.column_of[row]);
    const double cost = problem_.cost_of(mapping);
    if (cost > worst_ || (!found_.mapping.empty() && cost >= found_.cost)) return cost;
    found_.mapping = std::move(mapping);
    found_.cost = cost;
    worst_ = cost * (1 - kRounding);
    return cost;
  }

  // The row with the fewest columns that a better mapping could use.
  Choice choose(const Branch& branch, const AssignmentProblem& open, double slack) const {
    Choice best;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const std::size_t row : branch.rows) {
      Choice choice{row, {}};
      for (const std::size_t column : branch.columns) {
        const double dearer = branch.assignment.reduced(open, row, column);
        if (dearer <= slack) choice.columns.emplace_back(dearer, column);
      }
      if (choice.columns.size() >= fewest) continue;
      fewest = choice.columns.size();
      best = std::move(choice);
      if (fewest <= 1) break;
    }
    std::sort(best.columns.begin(), best.columns.end());
    return best;
  }

  void decide(Branch& branch, std::size_t row, std::size_t column) const {
    branch.decided += branch.costs[row * problem_.count + column];
    branch.mapping[row] = static_cast<std::uint8_t>(column);
    std::erase(branch.rows, row);
    std::erase(branch.columns, column);
    for (const std::size_t j : branch.rows)
      for (const std::size_t l : branch.columns)
        branch.costs[j * problem_.count + l] +=
            problem_.arc_cost(row, j, column, l) + problem_.arc_cost(j, row, l, column);
  }

  const MatchProblem& problem_;
  const SearchLimits& limits_;
  const std::chrono::steady_clock::time_point start_;
  double worst_;  // what a mapping may cost to be of interest
  std::size_t steps_ = 0;
  FoundMapping found_;
};

}  // namespace

double MatchProblem::arc_cost(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
  const Arc &a = arcs_a[i * count + j], &b = arcs_b[k * count + l];
  if (!a.known || !b.known) return 0;
  const double kind = a.kind == b.kind ? 0 : kind_cost;
  const bool directed =
      a.kind != Relation::Kind::superimposed && b.kind != Relation::Kind::superimposed;
  if (!directed) return kind;
  return kind +
         direction_cost[static_cast<std::size_t>(direction_distance(a.direction, b.direction))];
}

double MatchProblem::cost_of(const std::vector<std::uint8_t>& mapping) const {
  double cost = 0;
  for (std::size_t i = 0; i < count; ++i) {
    cost += node_costs[i * count + mapping[i]];
    for (std::size_t j = 0; j < count; ++j)
      if (i != j) cost += arc_cost(i, j, mapping[i], mapping[j]);
  }
  return cost;
}

FoundMapping search_mapping(const MatchProblem& problem, const SearchLimits& limits) {
  return Search(problem, limits).run();
}

}  // namespace aspect
