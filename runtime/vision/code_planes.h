// What stands for colour where a sensor measures something else: three numbers a pixel, alike
// within a surface and different across its border, so that all later stages stay as they are.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/planes.h"

namespace aspect {

// Which of them are anything, pixel by pixel like Planes: 255 or 0.
struct CodeMasks {
  std::span<std::uint8_t> foreground;
  std::span<std::uint8_t> solid;  // where a core may be
};

CodeMasks take_code_masks(Arena& arena, int width_px, int height_px);

// Of a frame of 16-bit numbers: smallest box of those in [least, most] within the part looked at,
// with a margin of 2 pixels. Empty where there are none.
Box box_of_numbers(const Frame& frame, const VisionParameters& parameters, int least, int most);

// Pixel x, y of such a frame, wherever its bytes lie.
std::uint16_t number_at(const Frame& frame, int x, int y);

}  // namespace aspect
