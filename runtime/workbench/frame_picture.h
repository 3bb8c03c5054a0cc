// A camera's frame as a picture for browsers.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "runtime/vision/frame.h"

namespace aspect {

// Colours of one pixel, without interpolation: of a Bayer frame those of its 2 x 2 cell.
std::array<std::uint8_t, 3> preview_rgb(const Frame& frame, int x, int y) noexcept;

struct PictureSize {
  int width_px = 0, height_px = 0;
};

// Scaled into the bounds where it is larger; keeps its shape.
PictureSize size_within(const PictureSize& frame, const PictureSize& bounds) noexcept;

// Of that size, as the middles of its pixels see the frame, in a BMP of 24 bits from the top down.
std::string bitmap_of(const Frame& frame, const PictureSize& size);

}  // namespace aspect
