// Stage "enhance", steps 1 and 2 of the thesis's segmentation (3.2.2): smooth without smearing
// edges, then normalise colours to their shares r:g:b, free of brightness and shading.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/vision/planes.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Median of 3 x 3 of every plane; pixels at the rim of the active part are copied. `scratch` holds
// kMedianRows rows.
inline constexpr std::size_t kMedianRows = 3;
void smooth(const Planes& from, std::span<std::uint8_t> scratch, Planes& to);

// The same of one row between two others; the first and the last pixel are copied.
void smooth_row(const std::uint8_t* above, const std::uint8_t* row, const std::uint8_t* below,
                int width, std::span<std::uint8_t> scratch, std::uint8_t* out);

// Pixels of a row as segmentation sees them: colour shares 255 r / (r + g + b) and so on.
struct ShareRow {
  const std::uint8_t *red, *green, *blue;
  const std::uint8_t* intensity;   // (r + g + b) / 3
  const std::uint8_t* tolerance;   // largest step of a share to a neighbour of the same region
  const std::uint8_t* foreground;  // 255 or 0

  ShareRow from(std::size_t x) const {
    return {red + x, green + x, blue + x, intensity + x, tolerance + x, foreground + x};
  }
};

// The same to be written; no two overlap.
struct MutableShareRow {
  std::uint8_t *red, *green, *blue, *intensity, *tolerance, *foreground;
};

void normalise(const std::uint8_t* red, const std::uint8_t* green, const std::uint8_t* blue,
               int count, const VisionParameters& parameters, const MutableShareRow& out);

// Which pixels reach the least intensity, 255 or 0.
void find_foreground(const std::uint8_t* red, const std::uint8_t* green, const std::uint8_t* blue,
                     int count, int intensity_min, std::uint8_t* foreground);

}  // namespace aspect
