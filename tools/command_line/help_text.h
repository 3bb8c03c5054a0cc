// What --help prints.
#pragma once

#include <string>

#include "tools/command_line/command_text.h"

namespace aspect {

// In lines of at most 100 columns, but for the command's own notes.
std::string help_text(const CommandText& command);

}  // namespace aspect
