// What the first bytes of a picture say, read before a decoder is let loose on it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace aspect {

// Why a PNG, JPEG or BMP file is not worth decoding: no pixels, a size outside of vision_limits.h,
// or cut off. None where nothing is wrong or the format is another one. O(bytes).
std::optional<std::string> picture_fault(std::span<const std::byte> file);

// Whether it is a PNG file of one channel of 16 bits: how range and surface frames are recorded.
bool is_deep_grey_png(std::span<const std::byte> file);

// The same verdict on a size, from wherever it is known.
std::optional<std::string> size_fault(std::int64_t width_px, std::int64_t height_px);

}  // namespace aspect
