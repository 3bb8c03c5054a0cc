// Rows of shares where the segmentation is at work, computed once each, in place of planes: six
// bytes a pixel of memory are saved, and rows are read again while they are in the cache.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/code_planes.h"
#include "runtime/vision/enhance.h"
#include "runtime/vision/planes.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// What a frame has become: colours or, of other sensors, codes, which are their own shares.
struct EnhancedFrame {
  Planes planes;
  const CodeMasks* codes = nullptr;  // of other sensors
  std::uint8_t code_tolerance = 0;
};

struct PixelShares {
  std::array<std::uint8_t, 3> share;
  std::uint8_t intensity, tolerance;
};

class ShareRows {
 public:
  void take(Arena& arena, int width_px);

  void begin(const EnhancedFrame& frame, const VisionParameters& parameters);

  // Row y of the active part, from its first pixel on. Valid until three other rows were asked for.
  ShareRow row(int y);

  // The shares of one pixel: through tables, since single ones divide slower than vectors do.
  PixelShares pixel(std::size_t place) const;

  // Foreground of row y of the active part, from its first pixel on. Valid until the next call.
  const std::uint8_t* foreground(int y);

 private:
  static constexpr int kRows = 3, kSums = 3 * 255 + 1;
  MutableShareRow stored(int slot) const;
  ShareRow compute(int y, int slot);
  void tabulate_tolerances();

  EnhancedFrame frame_;
  VisionParameters parameters_;
  std::span<std::uint8_t> rows_;
  std::span<std::uint8_t> foreground_;
  std::size_t width_ = 0;
  std::array<int, kRows> row_of_slot_{};
  std::array<std::uint8_t, kSums> tolerance_of_sum_{};
};

}  // namespace aspect
