// Stages "convert" and the first step of "enhance" of a colour or grey frame, a few rows at a time:
// rows that have just been converted are smoothed out of the cache, and no plane holds them.
#pragma once

#include <chrono>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/planes.h"

namespace aspect {

class ColourBands {
 public:
  void take(Arena& arena, int width_px);

  // Fills `planes`, of colours or of grey, within `box`, which becomes their active part. What is
  // at the rim of the box is not smoothed.
  void run(const Frame& frame, const Box& box, bool smooths, Planes& planes) noexcept;

  // Of the last run.
  std::chrono::nanoseconds converting() const { return converting_; }
  std::chrono::nanoseconds smoothing() const { return smoothing_; }

 private:
  // Clocks are read once a band.
  static constexpr int kBand = 8, kChannels = 3;
  std::span<std::uint8_t> stored(int y, int channel) const;
  void convert(const PixelRows& rows, int begin, int end);
  void smooth_rows(int begin, int end, Planes& planes);

  std::span<std::uint8_t> rows_;     // of a band and its neighbours, by row, then by channel
  std::span<std::uint8_t> scratch_;  // for the median
  std::size_t width_ = 0;
  Box box_;
  int channels_ = kChannels;
  std::chrono::nanoseconds converting_{}, smoothing_{};
};

}  // namespace aspect
