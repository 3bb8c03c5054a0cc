// A camera's noise: how a channel's variance grows with its value, from frames of anything.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Of a channel of value v, 0 to 255: variance = constant + per_grey * v, both at least 0. The first
// is of reading out, the second of light itself, which comes in photons.
struct NoiseModel {
  double constant = 0, per_grey = 0;

  double deviation(double value) const;
};

struct NoisePoint {
  double value = 0, variance = 0;
  std::size_t pixels = 0;
};

struct MeasuredNoise {
  NoiseModel model;
  std::vector<NoisePoint> points;  // that the model is laid through
  std::size_t pairs = 0;           // of frames in which the same stood still; 0: within frames
  bool is_compressed = false;      // blocks of 8 x 8 are seen: within frames noise seems less
};

// Pictures with three channels. Those that follow each other and show the same are compared pixel
// by pixel; where there are none, flat places within each are looked for, which is less exact.
// Fails where nothing is flat or all is dark or cut off.
Result<MeasuredNoise> measure_noise(const std::vector<cv::Mat>& pictures);

// The least noise_steps with which such noise on a surface of one colour parts no pixels of it,
// from intensity_min up; as vision works, smoothing included.
int noise_steps_for(const NoiseModel& model, const VisionParameters& vision);

}  // namespace aspect
