// Everything of an evaluation as one JSON object.
#pragma once

#include <string>

#include "tools/eval/evaluation.h"

namespace aspect {

std::string evaluation_json(const Evaluation& evaluation);

}  // namespace aspect
