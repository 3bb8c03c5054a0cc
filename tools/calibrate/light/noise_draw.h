// Noise over brightness, and the model through it.
#pragma once

#include <opencv2/core.hpp>

#include "tools/calibrate/light/noise_model.h"

namespace aspect {

cv::Mat draw_noise(const MeasuredNoise& noise);

}  // namespace aspect
