// Whether a camera changed its white balance or exposure between frames, which changes every
// colour.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace aspect {

// How much brighter what stands still is in a frame than in another, by channel r g b, as
// logarithms; nothing where too little stands still to say. Both CV_8UC3, blue first, of one size.
std::optional<Eigen::Vector3d> gain_between(const cv::Mat& from, const cv::Mat& to);

// One line for white balance, one for exposure, where what stands still says that they changed: by
// how much, between which frames, and the V4L2 controls that lock them.
std::vector<std::string> lock_warnings(const std::vector<cv::Mat>& pictures,
                                       const std::vector<std::string>& names);

// The line of a white balance that changed by that factor.
std::string white_balance_warning(double factor, const std::string& one, const std::string& other);

}  // namespace aspect
