// The smallest index there can be: one class, compiled from one picture.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

#include "runtime/vision/vision_parameters.h"

namespace aspect {

void write_tiny_index(const std::filesystem::path& file, const std::string& object,
                      const cv::Mat& picture, const VisionParameters& parameters = {});

}  // namespace aspect
