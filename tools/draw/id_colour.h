// Colours for things that only have a number.
#pragma once

#include <opencv2/core.hpp>

namespace aspect {

// Bright enough for a dark background; always the same one for an id, and far apart for ids that
// follow each other.
cv::Scalar id_colour(int id);

}  // namespace aspect
