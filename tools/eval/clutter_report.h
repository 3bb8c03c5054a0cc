// What an evaluation in clutter came to, for people and for programs.
#pragma once

#include <string>

#include "tools/eval/clutter_evaluation.h"

namespace aspect {

std::string clutter_text(const ClutterEvaluation& evaluation);
// As evaluation_json, but that every object has `clutter` in place of the results of its views.
std::string clutter_json(const ClutterEvaluation& evaluation);

}  // namespace aspect
