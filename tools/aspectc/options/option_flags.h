// The options of the table on a command line.
#pragma once

#include <vector>

#include "tools/aspectc/options/option_table.h"

namespace CLI {
class App;
}

namespace aspect {

struct GivenFlag {
  const Option* option;
  OptionValue value;
};

// Adds a flag for every option, in groups of their tables. What is given is appended to `given`,
// which must outlive the parsing; a value that is no good is a parse error.
void add_option_flags(CLI::App& app, std::vector<GivenFlag>& given);

}  // namespace aspect
