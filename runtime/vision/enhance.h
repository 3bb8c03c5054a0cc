// Stage "enhance", steps 1 and 2 of the thesis's segmentation (3.2.2): smooth without smearing
// edges, then normalise colours to their shares r:g:b, free of brightness and shading.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/planes.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Colour shares 255 r / (r + g + b) and so on; all planes are indexed like Planes.
struct Shares {
  std::span<std::uint8_t> red, green, blue;
  std::span<std::uint8_t> intensity;   // (r + g + b) / 3
  std::span<std::uint8_t> tolerance;   // largest step of a share to a neighbour of the same region
  std::span<std::uint8_t> foreground;  // 255 or 0
  int stride_px = 0;
  Box active;
  std::span<std::uint8_t> solid{};  // 0 where no core may be, 255 elsewhere; empty: nowhere
  bool are_codes = false;           // other sensors: the planes' own values and no ratios
};

Shares take_shares(Arena& arena, int width_px, int height_px);

// Median of 3 x 3 of every plane; pixels at the rim of the active part are copied.
// Two rows of scratch a plane are taken from `scratch`, at least 3 * width bytes.
void smooth(const Planes& from, std::span<std::uint8_t> scratch, Planes& to);

void normalise(const Planes& planes, const VisionParameters& parameters, Shares& shares);

}  // namespace aspect
