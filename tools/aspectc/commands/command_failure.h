// How every command of aspectc ends that cannot do what it was asked.
#pragma once

#include <string>

#include "tools/command_line/command_line.h"
#include "tools/command_line/terminal_colour.h"

namespace aspect {

// Prints the line and returns the exit code for it.
inline int fail(const std::string& message) {
  print_failure("aspectc", message);
  return 1;
}

// The same where the command line makes no sense.
inline int refuse_usage(const std::string& message) {
  fail(message);
  return kUsageError;
}

}  // namespace aspect
