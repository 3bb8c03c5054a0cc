// What was recognised, drawn over the frame.
#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "runtime/recognition/recogniser.h"

namespace aspect {

// Outlines of the regions in the colours of draw_regions, the contours' numbers with their names in
// the best hypothesis, the objects' boxes, and one line an object: name, verdict, probability,
// class, score, view. A match, or one of several, is drawn as its pose has it: the edges seen, and
// the object's axes from its centre, x red, y green, z blue, half its radius long. Small frames are
// blown up. `indexes`, `map` and `cameras` are those of the recogniser.
cv::Mat draw_recognition(const Frame& frame, const Recognition& recognition, const RegionMap& map,
                         std::span<const ClassIndex> indexes, std::span<const CameraModel> cameras);

// Of a model's edges in OpenCV's order: on a dark rim, so that they show on any surface.
inline const cv::Scalar kModelEdgeColour{255, 255, 255};

}  // namespace aspect
