// A reliability plot: what is believed against what is true.
#pragma once

#include <string>

#include "tools/eval/reliability.h"

namespace aspect {

// An SVG document: a point for each bin that holds views, mean probability to the right and share
// right upwards, their number over it at the top; the diagonal is where they belong.
std::string reliability_svg(const Reliability& reliability);

}  // namespace aspect
