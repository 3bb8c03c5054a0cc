// The command line of a program that CLI11 parses.
#pragma once

#include "tools/command_line/command_text.h"

namespace CLI {
class App;
}

namespace aspect {

// Of a program and its subcommands. What is in the group "" is hidden.
CommandText app_text(const CLI::App& app);

}  // namespace aspect
