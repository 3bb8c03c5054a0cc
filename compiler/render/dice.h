// Random numbers that are the same with every standard library.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <random>

namespace aspect {

class Dice {
 public:
  explicit Dice(std::size_t seed) : random_(static_cast<std::uint32_t>(seed)) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }
  std::size_t below(std::size_t count) { return random_() % count; }

  // A unit vector; all are alike probable.
  Eigen::Vector3d direction() {
    for (;;) {
      const Eigen::Vector3d v(between(-1, 1), between(-1, 1), between(-1, 1));
      if (v.squaredNorm() > 0.01 && v.squaredNorm() <= 1) return v.normalized();
    }
  }

 private:
  std::mt19937 random_;
};

}  // namespace aspect
