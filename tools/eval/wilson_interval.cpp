#include "tools/eval/wilson_interval.h"

#include <algorithm>
#include <cmath>

namespace aspect {

Share share_of(std::size_t count, std::size_t total) {
  if (total == 0) return {0, 0, 1};
  constexpr double z = 1.959964;  // 97.5 % of the normal distribution
  const auto n = static_cast<double>(total);
  const double p = static_cast<double>(count) / n;
  const double middle = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace aspect
