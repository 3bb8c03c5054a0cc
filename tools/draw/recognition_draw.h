// What was recognised, drawn over the frame.
#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "runtime/recognition/recogniser.h"

namespace aspect {

// Outlines of the regions in the colours of draw_regions, the contours' numbers with their names in
// the best hypothesis, the objects' boxes, and one line an object: name, class, score, view.
// Small frames are blown up. `indexes` and `map` are those of the recogniser.
cv::Mat draw_recognition(const Frame& frame, const Recognition& recognition, const RegionMap& map,
                         std::span<const ClassIndex> indexes);

}  // namespace aspect
