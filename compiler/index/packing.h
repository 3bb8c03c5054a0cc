// Numbers as integers of a unit.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace aspect {

// Rounded; what does not fit becomes the largest or smallest that does.
template <typename Integer>
Integer packed(double value, double unit) {
  constexpr auto kLow = static_cast<double>(std::numeric_limits<Integer>::min());
  constexpr auto kHigh = static_cast<double>(std::numeric_limits<Integer>::max());
  return static_cast<Integer>(std::lround(std::clamp(value * unit, kLow, kHigh)));
}

}  // namespace aspect
