// A plot of how the recall falls as more of an object is hidden.
#pragma once

#include <string>

#include "tools/eval/clutter_evaluation.h"

namespace aspect {

// An SVG document: a line for each object, a point at the middle of every range of shares hidden
// that has frames, with its 95 % interval (Wilson).
std::string recall_svg(const ClutterEvaluation& evaluation);

}  // namespace aspect
