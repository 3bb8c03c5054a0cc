// Stage "convert": the part of a frame that holds foreground, as separate colour planes.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/frame.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Three planes in frame coordinates: pixel x, y stands at y * stride_px + x. Only `active` holds
// pixels of the present frame; what lies outside it is background.
struct Planes {
  std::span<std::uint8_t> red, green, blue;
  int stride_px = 0;
  Box active;
};

Planes take_planes(Arena& arena, int width_px, int height_px);

// The region of interest, or the whole frame.
Box part_looked_at(const Frame& frame, const VisionParameters& parameters);

// Of a colour or grey frame: smallest box that holds every pixel which may reach intensity_min,
// with a margin of 2 pixels where the region of interest has them. Empty where there is none.
Box foreground_box(const Frame& frame, const VisionParameters& parameters);

// Grey is the colour whose three channels are one: all three planes are the same memory.
Planes take_grey_planes(Arena& arena, int width_px, int height_px);
void copy_grey(const Frame& frame, const Box& box, Planes& planes);

// Fills the planes within `box`, which becomes their active part.
void split_planes(const Frame& frame, const Box& box, Planes& planes);

}  // namespace aspect
