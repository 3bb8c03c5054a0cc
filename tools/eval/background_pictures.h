// The pictures of a folder as backgrounds.
#pragma once

#include <cstddef>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

struct BackgroundPictures {
  std::string folder;
  std::size_t found = 0;     // pictures in the folder
  std::vector<cv::Mat> rgb;  // 8 bits a channel, red first; in the order of their names
};

// More pictures than this are not read: of a folder that holds more, as many at even steps.
inline constexpr std::size_t kMostBackgrounds = 200;

// Pictures whose longer side is more than `longest_px` are made smaller, to that. Fails with the
// first that cannot be read, and where the folder is none or holds no picture. Not for
// several threads at once: see RecordedFrames.
Result<BackgroundPictures> read_backgrounds(const std::filesystem::path& folder, int longest_px);

}  // namespace aspect
