// Completion in bash: commands, options, and the values that the words for them tell of.
#pragma once

#include <string>

#include "tools/command_line/command_text.h"

namespace aspect {

// A script for bash 4 and later that needs nothing else; file it under the program's name.
std::string bash_completion(const CommandText& program);

}  // namespace aspect
