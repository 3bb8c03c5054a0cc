// How often tests with random input repeat. An emulated processor takes fifty times longer.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace aspect {

// `full`, or the share of it that the environment variable ASPECT_TEST_PERCENT says; at least one.
inline int rounds(int full) {
  const char* percent = std::getenv("ASPECT_TEST_PERCENT");
  return percent == nullptr ? full : std::max(1, full * std::atoi(percent) / 100);
}

}  // namespace aspect
