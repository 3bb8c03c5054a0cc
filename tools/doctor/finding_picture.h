// What is wrong with an object, marked on it.
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "tools/doctor/finding_lines.h"

namespace aspect {

inline constexpr int kView_px = 620;

// Where a number points at in the picture.
struct MarkedPlace {
  std::string label;
  std::size_t view = 0;
  cv::Point at;
};

struct FindingPicture {
  cv::Mat picture;
  std::vector<Eigen::Vector3d> views;  // directions to the camera
  std::vector<cv::Rect> places;        // of the views in the picture
  std::vector<MarkedPlace> marks;
};

// The object from the few views that show the most of the findings, these marked and numbered like
// the lines, which stand below. Of an object without findings one view.
Result<FindingPicture> finding_picture(const PreparedObject& object, const Diagnosis& diagnosis,
                                       std::span<const FindingLine> lines);

}  // namespace aspect
