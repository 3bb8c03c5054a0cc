// An evaluation as tables to read.
#pragma once

#include <string>

#include "tools/eval/evaluation.h"

namespace aspect {

std::string evaluation_text(const Evaluation& evaluation);

}  // namespace aspect
