#include "tools/calibrate/light/noise_draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/draw/picture_text.h"

namespace aspect {

cv::Mat draw_noise(const MeasuredNoise& noise) {
  constexpr int kLeft = 56, kTop = 40, kWidth = 512, kHeight = 320;
  const cv::Scalar dim(96, 96, 96), light(235, 235, 235), blue(255, 170, 80), red(80, 80, 255);
  cv::Mat drawn(kTop + kHeight + 40, kLeft + kWidth + 24, CV_8UC3, cv::Scalar(24, 24, 24));
  double most = noise.model.deviation(255);
  for (const NoisePoint& p : noise.points) most = std::max(most, std::sqrt(p.variance));
  most = std::max(1.0, std::ceil(1.1 * most));
  const auto at = [&](double value, double deviation) {
    return cv::Point(kLeft + static_cast<int>(value / 255 * kWidth),
                     kTop + kHeight - static_cast<int>(deviation / most * kHeight));
  };
  const TextStyle style{0.42, 1, 16};
  for (int tick = 0; tick <= 4; ++tick) {
    const double deviation = most * tick / 4, value = 255.0 * tick / 4;
    cv::line(drawn, at(0, deviation), at(255, deviation), dim, 1);
    draw_text(drawn, fmt::format("{:.2f}", deviation), at(0, deviation) + cv::Point(-48, -8), style,
              light);
    draw_text(drawn, fmt::format("{:.0f}", value), at(value, 0) + cv::Point(-10, 8), style, light);
  }
  for (int value = 1; value <= 255; ++value)
    cv::line(drawn, at(value - 1, noise.model.deviation(value - 1)),
             at(value, noise.model.deviation(value)), red, 2, cv::LINE_AA);
  for (const NoisePoint& p : noise.points)
    cv::circle(drawn, at(p.value, std::sqrt(p.variance)), 4, blue, cv::FILLED, cv::LINE_AA);
  draw_text(drawn,
            fmt::format("noise (grey values) over brightness: variance {:.2f} + {:.4f} v",
                        noise.model.constant, noise.model.per_grey),
            {8, 8}, style, light);
  return drawn;
}

}  // namespace aspect
