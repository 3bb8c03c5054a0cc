// How common colours are in pictures of where an object will be used.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "tools/explain/colour_presence.h"

namespace aspect {

// A connected piece (by pixels' sides) of at least this share of its picture is a region.
inline constexpr double kLeastRegionShare = 0.001;

// Of every colour (any brightness; only r : g : b matters). A pixel is of a colour where its own
// shares of r, g and b are within the recogniser's reach, kColourReach, and it is no darker than
// `intensity_min`, r + g + b. Pictures are of 8 bits a channel, red first. Same result for any
// number of threads. O(pixels * colours).
std::vector<ColourPresence> presence_of(std::span<const Eigen::Vector3d> colours,
                                        std::span<const cv::Mat> pictures, int intensity_min);

}  // namespace aspect
