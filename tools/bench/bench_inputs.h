// What several benchmarks start from.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <utility>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

template <typename Value>
Value checked(Result<Value> result) {
  if (!result) {
    std::fprintf(stderr, "aspect-bench: %s\n", result.error().c_str());
    std::exit(1);
  }
  return std::move(result).value();
}

// Of this thread: what other programs take of a shared machine does not count.
inline double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline std::filesystem::path source_path(const char* below) {
  return std::filesystem::path(ASPECT_SOURCE_DIR) / below;
}

// A hundred directions, evenly spread by the golden angle.
inline std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> spread;
  for (int i = 0; i < 100; ++i) {
    const double z = (2 * i + 1) / 100.0 - 1, angle = 2.399963229728653 * i;
    const double radius = std::sqrt(1 - z * z);
    spread.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return spread;
}

}  // namespace aspect
