// The --stats file.
#pragma once

#include <string>
#include <vector>

#include "compiler/compile.h"

namespace aspect {

// Of each object; without a list there is one, on its own.
std::string statistics_json(const std::vector<CompileStatistics>& all, bool as_list);

}  // namespace aspect
