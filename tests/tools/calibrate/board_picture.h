// Pictures of a board as a camera takes them, with exact truth: rays through a lens that OpenCV
// undoes, the board's pattern by formula, several rays a pixel, then blur and noise.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/rigid_pose.h"
#include "tools/calibrate/board/board.h"

namespace aspect {

struct TakingCamera {
  CameraModel model;
  int width_px = 640, height_px = 480;
  double blur_px = 0.7, noise = 2;  // standard deviations; the latter in grey values
};

// A lens that bends as a cheap wide one does.
TakingCamera wide_camera(int width_px, int height_px);

class BoardStudio {
 public:
  BoardStudio(const Board& board, const TakingCamera& camera);

  // Grey; `camera_from_board` takes the board's mm, z away from who reads it, to the camera's.
  cv::Mat take(const RigidPose& camera_from_board, unsigned seed) const;

  // Where the camera has a corner exactly.
  cv::Point2d corner(const RigidPose& camera_from_board, int number) const;

  // Places all over the picture, the board tilted by 15 to 40 degrees to all sides. `whole`: all of
  // its corners are in the picture; otherwise half of them at least. The same seed gives the same.
  std::vector<RigidPose> poses(int count, unsigned seed, bool whole) const;

 private:
  Board board_;
  TakingCamera camera_;
  const std::vector<cv::Point2f>& rays() const;
  // x / z, y / z; kSide * kSide a pixel, row by row; empty before the first picture.
  mutable std::vector<cv::Point2f> rays_;
};

}  // namespace aspect
