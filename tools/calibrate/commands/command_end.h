// How every command of aspect-calibrate ends that cannot do what it was asked, and what all of them
// say on the way.
#pragma once

#include <string>
#include <vector>

#include "tools/command_line/command_line.h"
#include "tools/command_line/terminal_colour.h"

namespace aspect {

inline constexpr const char* kCalibrateProgram = "aspect-calibrate";

// Prints the line and returns the exit code for it.
inline int end_failed(const std::string& message) {
  print_failure(kCalibrateProgram, message);
  return 1;
}

// The same where the command line makes no sense.
inline int end_misused(const std::string& message) {
  print_failure(kCalibrateProgram, message);
  return kUsageError;
}

inline void warn_all(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_warning(kCalibrateProgram, warning);
}

}  // namespace aspect
