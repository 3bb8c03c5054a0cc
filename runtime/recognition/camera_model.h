// A calibrated camera: a pinhole with OpenCV's lens model.
#pragma once

#include <array>

namespace aspect {

struct Point2d {
  double x = 0, y = 0;
};

// Pixel centres are at whole numbers. Points of a picture without distortion, "straight" ones, are
// where a pinhole with the same focal lengths and principal point would show them.
struct CameraModel {
  double fx_px = 0, fy_px = 0, cx_px = 0, cy_px = 0;
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

  bool is_straight() const { return k1 == 0 && k2 == 0 && p1 == 0 && p2 == 0 && k3 == 0; }

  // Where the lens shows a straight point.
  Point2d bent(Point2d straight_px) const;
  // The reverse, by fixed-point iteration: to 0.01 px for cameras that is_sound() allows.
  Point2d straight(Point2d bent_px) const;
};

// Finite, focal lengths above zero, and no two points of the picture in one place: the bent radius
// grows with the straight one up to the picture's corners.
bool is_sound(const CameraModel& camera, int width_px, int height_px);

}  // namespace aspect
