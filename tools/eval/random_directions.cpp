#include "tools/eval/random_directions.h"

#include <cmath>
#include <random>

namespace aspect {
namespace {

// The standard fixes the numbers of mt19937_64, but not those of its distributions.
double from_minus_one_to_one(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11U) * 0x1p-52 - 1;
}

}  // namespace

std::vector<Eigen::Vector3d> random_directions(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<Eigen::Vector3d> directions;
  directions.reserve(count);
  while (directions.size() < count) {
    const double u = from_minus_one_to_one(generator), v = from_minus_one_to_one(generator);
    const double squares = u * u + v * v;
    if (squares >= 1) continue;
    const double root = 2 * std::sqrt(1 - squares);
    directions.emplace_back(u * root, v * root, 1 - 2 * squares);
  }
  return directions;
}

}  // namespace aspect
