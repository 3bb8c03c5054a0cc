// From OpenCV's picture to ours, inside the readers only.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

#include "runtime/capture/frame_source.h"

namespace aspect {

// `picture` has the pixels of `format`, those of colours blue first.
inline void copy_picture(const cv::Mat& picture, PixelFormat format, CapturedFrame& frame) {
  frame.width_px = picture.cols;
  frame.height_px = picture.rows;
  frame.format = format;
  const auto row_bytes =
      static_cast<std::size_t>(bytes_per_pixel(format)) * static_cast<std::size_t>(picture.cols);
  frame.pixels.resize(row_bytes * static_cast<std::size_t>(picture.rows));
  for (int y = 0; y < picture.rows; ++y)
    std::copy_n(picture.ptr<std::uint8_t>(y), row_bytes,
                frame.pixels.data() + row_bytes * static_cast<std::size_t>(y));
}

}  // namespace aspect
