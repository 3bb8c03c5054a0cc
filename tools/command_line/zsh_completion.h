// Completion in zsh, by its own _arguments: what bash's offers, with the meaning of every option.
#pragma once

#include <string>

#include "tools/command_line/command_text.h"

namespace aspect {

// An autoloaded function; file it under "_" and the program's name.
std::string zsh_completion(const CommandText& program);

}  // namespace aspect
