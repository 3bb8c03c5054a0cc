// The confusion table as a heat map.
#pragma once

#include <string>

#include "tools/eval/evaluation.h"

namespace aspect {

// An SVG document: a row for each object that was there, a column for each that came first and one
// for none; the darker, the larger the share of the row. The evaluation must have a confusion.
std::string confusion_svg(const Evaluation& evaluation);

}  // namespace aspect
