#include "tools/eval/random_directions.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

namespace aspect {
namespace {

TEST_CASE("Directions are unit vectors, spread evenly over the sphere") {
  constexpr std::size_t kCount = 20000;
  const auto directions = random_directions(kCount, 3);
  REQUIRE(directions.size() == kCount);
  // By Archimedes, each coordinate of an even spread is uniform: ten slices of equal weight.
  std::array<std::array<int, 10>, 3> slices{};
  for (const Eigen::Vector3d& d : directions) {
    CHECK(std::abs(d.norm() - 1) < 1e-12);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      ++slices[static_cast<std::size_t>(axis)]
              [static_cast<std::size_t>(std::min(9.0, std::floor((d[axis] + 1) * 5)))];
  }
  // 2000 each with a standard deviation of 42.
  for (const auto& axis : slices)
    for (const int count : axis) CHECK(std::abs(count - 2000) < 200);
}

TEST_CASE("A seed gives the same directions on every machine, however many are asked for") {
  const auto few = random_directions(3, 1), many = random_directions(50, 1);
  for (std::size_t k = 0; k < few.size(); ++k) CHECK(few[k] == many[k]);
  CHECK(random_directions(1, 2)[0] != few[0]);
  CHECK(random_directions(0, 1).empty());
  CHECK(few[0].isApprox(
      Eigen::Vector3d(-0.05265497211471828, -0.5169705070576001, -0.8543822029655148), 1e-15));
}

}  // namespace
}  // namespace aspect
