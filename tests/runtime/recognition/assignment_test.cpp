#include "runtime/recognition/assignment.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <vector>

#include "tests/rounds.h"

namespace aspect {
namespace {

// The largest sum of any matching, row by row: each stays alone or takes a free column.
double plain_best(const std::vector<double>& weights, std::size_t rows, std::size_t columns,
                  std::size_t row, unsigned used) {
  if (row == rows) return 0;
  double best = plain_best(weights, rows, columns, row + 1, used);
  for (std::size_t column = 0; column < columns; ++column) {
    const double weight = weights[row * columns + column];
    if ((used >> column & 1U) != 0 || !(weight > 0)) continue;
    best =
        std::max(best, weight + plain_best(weights, rows, columns, row + 1, used | 1U << column));
  }
  return best;
}

// Few different weights, so that ties are common; some zero, some below.
std::vector<double> random_weights(std::mt19937& random, std::size_t count, int kind) {
  std::vector<double> weights(count);
  for (double& weight : weights) {
    if (kind == 0)
      weight = static_cast<double>(random() % 4);
    else if (kind == 1)
      weight = static_cast<double>(random() % 1000) / 64 - 3;
    else
      weight = random() % 3 == 0 ? 1e6 + static_cast<double>(random() % 5) : 0;
  }
  return weights;
}

void check_consistent(const std::vector<double>& weights, std::size_t rows, std::size_t columns,
                      const Assignment& assignment) {
  std::set<int> taken;
  double sum = 0;
  int matched = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const int column = assignment.column_of[row];
    REQUIRE((column >= -1 && column < static_cast<int>(columns)));
    if (column < 0) continue;
    const double weight = weights[row * columns + static_cast<std::size_t>(column)];
    CHECK(taken.insert(column).second);
    CHECK(weight > 0);
    sum += weight;
    ++matched;
  }
  CHECK(assignment.matched == matched);
  CHECK(assignment.weight == Approx(sum));
}

}  // namespace

TEST_CASE("the assignment is worth as much as the best of all matchings") {
  std::mt19937 random(1);
  Assignment assignment;
  for (int round = 0; round < rounds(2100); ++round) {
    const std::size_t rows = 1 + random() % 6, columns = 1 + random() % 7;
    const std::vector<double> weights = random_weights(random, rows * columns, round % 3);
    assign(weights, rows, columns, assignment);
    INFO("round " << round << ": " << rows << " x " << columns);
    check_consistent(weights, rows, columns, assignment);
    CHECK(assignment.weight == Approx(plain_best(weights, rows, columns, 0, 0)).epsilon(1e-12));
  }
}

TEST_CASE("with a large worth of each match, as many as possible are matched") {
  // Row 0 could have the heaviest pair, but then row 1 would stay alone.
  const std::vector<double> weights = {1e6 + 900, 1e6 + 1, 1e6 + 5, 0};
  Assignment assignment;
  assign(weights, 2, 2, assignment);
  CHECK(assignment.matched == 2);
  CHECK(assignment.weight == 2e6 + 6);
}

TEST_CASE("nothing is matched where there is nothing to match") {
  Assignment assignment;
  assignment.matched = 7;
  assign({}, 0, 0, assignment);
  CHECK((assignment.matched == 0 && assignment.weight == 0));
  assign({}, 3, 0, assignment);
  CHECK(std::all_of(assignment.column_of.begin(), assignment.column_of.begin() + 3,
                    [](int column) { return column == -1; }));
  const std::vector<double> zeros(12, 0.0);
  assign(zeros, 3, 4, assignment);
  CHECK(assignment.matched == 0);
}

TEST_CASE("the largest sides there may be are assigned, and one row as well") {
  std::mt19937 random(2);
  Assignment assignment;
  std::vector<double> weights(kMaxSide * kMaxSide);
  for (std::size_t row = 0; row < kMaxSide; ++row)
    for (std::size_t column = 0; column < kMaxSide; ++column)
      weights[row * kMaxSide + column] =
          column == (row * 5 + 3) % kMaxSide ? 2 : static_cast<double>(random() % 100) / 100;
  assign(weights, kMaxSide, kMaxSide, assignment);
  check_consistent(weights, kMaxSide, kMaxSide, assignment);
  // 5 and 48 have no common divisor: the twos are a matching, and nothing beats them.
  CHECK(assignment.weight == Approx(2.0 * kMaxSide));
  assign(weights, 1, kMaxSide, assignment);
  CHECK(assignment.column_of[0] == 3);
}

}  // namespace aspect
