// Pictures that are transparent in places, inside the readers only.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <string>

namespace aspect {

// `picture` is the file's, decoded into one or three channels of 8 bits or one of 16, and turned as
// it says. What is transparent in the file becomes black, or no depth and no surface, which are
// background; what is so in part darkens by as much, its shares of colours being kept. Returns why
// the transparency cannot be read.
[[nodiscard]] std::optional<std::string> blacken_transparent(std::span<const std::byte> file,
                                                             cv::Mat& picture);

}  // namespace aspect
