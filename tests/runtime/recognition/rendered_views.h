// Frames of models from anywhere, and the indexes that recognise them.
#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

#include "compiler/render/renderer.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

// A frame that owns its pixels.
struct OwnedFrame {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;
  Frame frame() const {
    return {rgb.data(), width_px, height_px, std::ptrdiff_t{3} * width_px, PixelFormat::rgb8};
  }
};

// Compiled at that level, as aspectc would.
ClassIndex model_index(const std::string& name, int level);

class ModelCamera {
 public:
  explicit ModelCamera(const std::string& name);

  // The camera is turned about its axis by -roll: the picture turns clockwise by roll.
  OwnedFrame view(const Eigen::Vector3d& direction, double roll_rad = 0);

 private:
  Studio studio_;
  Renderer renderer_;
  Picture picture_;
};

OwnedFrame beside(const OwnedFrame& left, const OwnedFrame& right);

Eigen::Vector3d random_direction(std::mt19937& random);

double angle_deg(const Vector3& a, const Eigen::Vector3d& b);

}  // namespace aspect
