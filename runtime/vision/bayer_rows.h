// Rows of red, green and blue from a picture behind a Bayer filter, by bilinear interpolation.
#pragma once

#include <cstdint>

#include "runtime/vision/frame.h"

namespace aspect {

// Pixels [x, x + count) of row y of a frame in one of the bayer formats.
void bayer_row(const Frame& frame, int y, int x, int count, std::uint8_t* red, std::uint8_t* green,
               std::uint8_t* blue);

}  // namespace aspect
