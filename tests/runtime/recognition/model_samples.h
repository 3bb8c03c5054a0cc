// What tests of recognition need from the compiler half: indexes of models and frames of them. A
// workstation makes them; with the environment variable ASPECT_SAMPLES, the name of a folder, it
// keeps each as a file there, and takes indexes from there that this build has made. A device,
// which has no compiler, reads all from there.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/vision/frame.h"

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
std::vector<std::uint8_t> model_index_bytes(const std::string& name, int level);

// Small: a cube seen in small pictures.
std::vector<std::uint8_t> small_index_bytes();

class ModelCamera {
 public:
  explicit ModelCamera(const std::string& name);
  ~ModelCamera();
  ModelCamera(ModelCamera&& other) noexcept;

  // The camera is turned about its axis by -roll: the picture turns clockwise by roll.
  OwnedFrame view(const Eigen::Vector3d& direction, double roll_rad = 0);

 private:
  class Maker;
  std::string name_;
  std::unique_ptr<Maker> maker_;
};

}  // namespace aspect
