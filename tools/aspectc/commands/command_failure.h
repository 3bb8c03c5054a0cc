// How every command of aspectc ends that cannot do what it was asked.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace aspect {

// Prints the line and returns the exit code for it.
inline int fail(const std::string& message) {
  fmt::print(stderr, "aspectc: {}\n", message);
  return 1;
}

}  // namespace aspect
