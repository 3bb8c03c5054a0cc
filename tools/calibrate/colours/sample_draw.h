// Where colours were sampled.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "tools/calibrate/colours/surface_colours.h"

namespace aspect {

// Sampled pixels hatched, each area outlined in the colour of its paint's number, and below a
// swatch a paint: as the scene has it on the left, as measured in this frame on the right. `paints`
// is the frame's map, empty where there is none.
cv::Mat draw_samples(const cv::Mat& picture, const cv::Mat& map, const std::vector<Paint>& paints,
                     const std::vector<PaintSample>& samples, const std::string& caption);

}  // namespace aspect
