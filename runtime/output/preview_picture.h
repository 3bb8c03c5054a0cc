// The newest camera frame, small, for a page to fetch.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/vision/frame.h"

namespace aspect {

// Colours of one pixel, without interpolation: of a Bayer frame those of its 2 x 2 cell.
std::array<std::uint8_t, 3> preview_rgb(const Frame& frame, int x, int y) noexcept;

class PreviewPicture {
 public:
  static constexpr int kWidth_px = 320, kHeight_px = 240;  // at most

  PreviewPicture();

  // Somebody asked in the last 2 seconds and has got the last one.
  bool wanted() const noexcept;
  // Never waits: a picture that is just being fetched stays. `line` is the number of the line that
  // belongs to it.
  void show(const Frame& frame, std::uint64_t line) noexcept;

  struct Bitmap {
    std::uint64_t line = 0;
    std::string bmp;
  };
  // None if there is nothing newer than the picture of that line.
  std::optional<Bitmap> fetch(std::optional<std::uint64_t> after);

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<Clock::rep> asked_{0};
  std::atomic<bool> fetched_{true};
  std::mutex mutex_;  // of what follows; the loop only ever tries it
  std::vector<std::uint8_t> rows_;
  int width_px_ = 0, height_px_ = 0;
  std::uint64_t line_ = 0;
};

}  // namespace aspect
