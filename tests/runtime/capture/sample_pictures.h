// Pictures as the bytes of a file.
#pragma once

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

namespace aspect {

inline std::string encoded(const cv::Mat& picture, const std::string& ending) {
  std::vector<unsigned char> bytes;
  cv::imencode(ending, picture, bytes);
  return {bytes.begin(), bytes.end()};
}

inline cv::Mat noise(int width_px, int height_px) {
  cv::Mat picture(height_px, width_px, CV_8UC3);
  cv::RNG random(11);
  random.fill(picture, cv::RNG::UNIFORM, 0, 256);
  return picture;
}

}  // namespace aspect
