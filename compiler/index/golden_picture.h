// A view as a golden frame's picture: one colour a region, in as few bytes as its coding gives.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/recognition/golden_frame.h"
#include "runtime/vision/segment.h"

namespace aspect {

// Colour 0 is the background.
struct PalettePicture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> palette;  // as GoldenFrame's
  std::vector<std::uint8_t> colours;  // of the pixels, row by row
};

// The regions of a frame that `map` was found in, cropped to them with a margin of
// kGoldenMargin_px. Nothing where there are none, too many, or the picture is too large.
inline constexpr int kGoldenMargin_px = 3;
std::optional<PalettePicture> palette_picture(const Frame& frame, const RegionMap& map,
                                              SensorKind sensor);

// Every second, third, ... pixel of each row and column, so that no side is longer than asked for.
PalettePicture thinned_out(const PalettePicture& picture, int longer_side_px);

// Without an answer yet. Nothing where a row has too many runs.
std::optional<GoldenFrame> encode_golden_frame(const PalettePicture& picture);

}  // namespace aspect
