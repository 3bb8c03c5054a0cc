// A camera from pictures of a board: focal lengths, principal point and OpenCV's lens model (Zhang,
// A flexible new technique for camera calibration, 2000).
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/recognition/camera_model.h"
#include "tools/calibrate/camera/board_corners.h"

namespace aspect {

struct BoardPicture {
  std::string name;
  SeenBoard seen;
};

struct FittedPicture {
  double residual_px = 0;            // root mean square
  std::vector<cv::Point2f> drawn;    // where the fitted camera has the corners seen
  cv::Vec3d normal_camera{0, 0, 1};  // of the board, away from the camera
};

struct CameraFit {
  CameraModel model;
  int width_px = 0, height_px = 0;
  double residual_px = 0;  // root mean square over all corners
  // Standard deviations of the estimates, as the residuals have it.
  double fx_error_px = 0, fy_error_px = 0, cx_error_px = 0, cy_error_px = 0;
  bool has_k3 = true;                   // or the pictures do not say it, and it is 0
  std::vector<FittedPicture> pictures;  // in the order given
  std::size_t dropped_corners = 0;      // that lay far from where all others have them
  double covered_share = 0;             // of the picture, by the corners' hulls together
};

inline constexpr std::size_t kLeastBoardPictures = 3;

// Fails where the pictures do not say a camera, or say one that no lens is like. k3 is left out
// where it is not known from zero, or where with it the lens would fold the picture. Corners far
// off are taken out of `pictures`, and the rest is fitted again.
Result<CameraFit> fit_camera(std::vector<BoardPicture>& pictures, const Board& board,
                             cv::Size size);

// One line each: too few pictures, too little of the picture covered, all from one side, a high
// residual with the worst pictures' names, an uncertain focal length.
std::vector<std::string> fit_warnings(const CameraFit& fit,
                                      const std::vector<BoardPicture>& pictures);

}  // namespace aspect
