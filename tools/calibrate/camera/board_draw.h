// What was found of a board, and how well the fitted camera says it.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "tools/calibrate/board/board.h"
#include "tools/calibrate/camera/camera_fit.h"

namespace aspect {

// Corners in rings by row, joined in their order, with an arrow from each to where the fitted
// camera has it, kResidualScale times as long.
inline constexpr double kResidualScale = 50;
cv::Mat draw_board(const cv::Mat& picture, const SeenBoard& seen, const Board& board,
                   const FittedPicture* fitted);

// All pictures' corners and arrows in one, on the hulls that they cover.
cv::Mat draw_coverage(const std::vector<BoardPicture>& pictures, const CameraFit& fit);

}  // namespace aspect
