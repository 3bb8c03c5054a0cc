// The --stats file.
#pragma once

#include <string>

#include "compiler/compile.h"

namespace aspect {

std::string statistics_json(const CompileStatistics& statistics);

}  // namespace aspect
