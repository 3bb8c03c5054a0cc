// Colours pixel by pixel as separate planes, and the part of a frame that holds foreground.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/frame.h"
#include "runtime/vision/pixel_rows.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Three planes in frame coordinates: pixel x, y stands at y * stride_px + x. Only `active` holds
// pixels of the present frame; what lies outside it is background.
struct Planes {
  std::span<std::uint8_t> red, green, blue;
  int stride_px = 0;
  Box active;

  bool is_grey() const { return green.data() == red.data(); }
  std::size_t place(int x, int y) const { return static_cast<std::size_t>(y * stride_px + x); }
};

Planes take_planes(Arena& arena, int width_px, int height_px);

// Grey is the colour whose three channels are one: all three planes are the same memory.
Planes take_grey_planes(Arena& arena, int width_px, int height_px);

// The region of interest, or the whole frame.
Box part_looked_at(const Frame& frame, const VisionParameters& parameters);

// Of a colour or grey frame: a box that holds every pixel which may reach intensity_min, with a
// margin of 2 pixels where the region of interest has them. The smallest one in the formats whose
// bytes are channels. Empty where there is none.
Box foreground_box(const Frame& frame, const VisionParameters& parameters);

}  // namespace aspect
