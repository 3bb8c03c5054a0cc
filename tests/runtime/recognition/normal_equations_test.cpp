#include "runtime/recognition/normal_equations.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

namespace aspect {
namespace {

using Slopes = Eigen::Matrix<double, Eigen::Dynamic, 6>;

}  // namespace

TEST_CASE("Steps and covariances are those of Eigen's least squares") {
  std::mt19937 random(4);
  std::normal_distribution<double> number;
  for (int round = 0; round < 50; ++round) {
    constexpr int kEquations = 40;
    Slopes slopes(kEquations, 6);
    Eigen::VectorXd targets(kEquations);
    NormalEquations equations;
    for (int k = 0; k < kEquations; ++k) {
      std::array<double, 6> slope{};
      for (std::size_t c = 0; c < 6; ++c) {
        slope[c] = 100 * number(random);
        slopes(k, static_cast<int>(c)) = slope[c];
      }
      targets[k] = number(random);
      equations.add(slope, targets[k], 1);
    }
    const Eigen::VectorXd expected = slopes.colPivHouseholderQr().solve(targets);
    const auto step = equations.solve(1);
    REQUIRE(step);
    // Damping holds a step back by a thousandth at most.
    for (std::size_t c = 0; c < 6; ++c)
      CHECK((*step)[c] == Approx(expected[static_cast<int>(c)]).epsilon(0.01).margin(1e-5));
    const Eigen::MatrixXd covariance = 0.25 * (slopes.transpose() * slopes).inverse();
    const auto found = equations.covariance(0.25, 1);
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        CHECK(found[static_cast<std::size_t>(6 * r + c)] ==
              Approx(covariance(r, c)).epsilon(0.02).margin(1e-8));
  }
}

TEST_CASE("What was not measured does not move, and its variance is large") {
  NormalEquations equations;
  for (int k = 1; k < 10; ++k) equations.add({0, 0, 0, 0, 100.0 * k, 0}, 1.0 * k, 1);
  const auto step = equations.solve(1);
  REQUIRE(step);
  CHECK((*step)[4] == Approx(0.01).epsilon(0.01));
  for (const std::size_t c : {0U, 1U, 2U, 3U, 5U}) CHECK((*step)[c] == Approx(0).margin(1e-12));
  const auto covariance = equations.covariance(1, 1);
  CHECK(covariance[7 * 3] > 100 * covariance[7 * 4]);
}

TEST_CASE("No equations give no step") {
  CHECK_FALSE(NormalEquations().solve(1));
}

}  // namespace aspect
