// Numbers that look random and depend on nothing but what they are for, so that a picture has the
// same bytes whichever thread draws it.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace aspect {

// Stands for one ray of one point of the picture.
class SampleKey {
 public:
  SampleKey() = default;
  SampleKey(std::int64_t column, std::int64_t row) {
    *this = child(static_cast<std::uint64_t>(column)).child(static_cast<std::uint64_t>(row));
  }

  // The key of the ray's n-th offspring, of whatever kind.
  SampleKey child(std::uint64_t n) const {
    SampleKey result;
    result.bits_ = mixed(bits_ ^ mixed(n + 0x9e3779b97f4a7c15u));
    return result;
  }

  // In [0, 1).
  double number(std::uint64_t n) const {
    return static_cast<double>(child(n).bits_ >> 11) * 0x1p-53;
  }

  // In the ball of radius 1.
  Eigen::Vector3d in_ball() const {
    const double z = 2 * number(0) - 1, angle = 2 * std::numbers::pi * number(1);
    const double across = std::sqrt(1 - z * z);
    return std::cbrt(number(2)) *
           Eigen::Vector3d(across * std::cos(angle), across * std::sin(angle), z);
  }

 private:
  // The output function of Steele, Lea and Flood's SplitMix64 (OOPSLA 2014).
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t bits_ = 0;
};

// The k-th of `count` points spread evenly over the unit disc along a spiral (Vogel 1979), the
// whole pattern turned by a share of a full turn.
inline Eigen::Vector2d disc_point(int k, int count, double turn) {
  constexpr double kGoldenAngle = std::numbers::pi * 0.7639320225002103;  // (3 - sqrt 5) pi
  const double radius = std::sqrt((k + 0.5) / count);
  const double angle = k * kGoldenAngle + 2 * std::numbers::pi * turn;
  return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

}  // namespace aspect
