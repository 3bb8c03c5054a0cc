#include "runtime/vision/colour_bands.h"

#include <algorithm>
#include <array>

#include "runtime/vision/enhance.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kNeighbours = 2;  // rows above and below a band

std::array<std::uint8_t*, 3> row_of(const Planes& planes, int x, int y) {
  const std::size_t at = planes.place(x, y);
  return {planes.red.data() + at, planes.green.data() + at, planes.blue.data() + at};
}

void read_row(const PixelRows& rows, int y, const Box& box, const std::array<std::uint8_t*, 3>& out,
              bool grey) {
  if (grey)
    rows.greys(y, box.x, box.width, out[0]);
  else
    rows.colours(y, box.x, box.width, {out[0], out[1], out[2]});
}

}  // namespace

void ColourBands::take(Arena& arena, int width_px) {
  width_ = static_cast<std::size_t>(width_px);
  rows_ = arena.take<std::uint8_t>((kBand + kNeighbours) * kChannels * width_);
  scratch_ = arena.take<std::uint8_t>(kMedianRows * width_);
}

std::span<std::uint8_t> ColourBands::stored(int y, int channel) const {
  const int slot = (y - box_.y) % (kBand + kNeighbours) * kChannels + channel;
  return rows_.subspan(static_cast<std::size_t>(slot) * width_, width_);
}

void ColourBands::convert(const PixelRows& rows, int begin, int end) {
  for (int y = begin; y < end; ++y)
    read_row(rows, y, box_, {stored(y, 0).data(), stored(y, 1).data(), stored(y, 2).data()},
             channels_ == 1);
}

void ColourBands::smooth_rows(int begin, int end, Planes& planes) {
  for (int y = begin; y < end; ++y) {
    const bool rim = y == box_.y || y + 1 == box_.y + box_.height;
    const std::array<std::uint8_t*, 3> out = row_of(planes, box_.x, y);
    for (int channel = 0; channel < channels_; ++channel) {
      const std::uint8_t* row = stored(y, channel).data();
      if (rim)
        std::copy_n(row, box_.width, out[static_cast<std::size_t>(channel)]);
      else
        smooth_row(stored(y - 1, channel).data(), row, stored(y + 1, channel).data(), box_.width,
                   scratch_, out[static_cast<std::size_t>(channel)]);
    }
  }
}

void ColourBands::run(const Frame& frame, const Box& box, bool smooths, Planes& planes) noexcept {
  const PixelRows rows(frame);
  box_ = planes.active = box;
  channels_ = planes.is_grey() ? 1 : kChannels;
  converting_ = smoothing_ = {};
  const int end = box.y + box.height;
  auto time = Clock::now();
  if (!smooths) {
    for (int y = box.y; y < end; ++y)
      read_row(rows, y, box, row_of(planes, box.x, y), planes.is_grey());
    converting_ = Clock::now() - time;
    return;
  }
  int converted = box.y;
  for (int begin = box.y; begin < end; begin += kBand) {
    const int stop = std::min(begin + kBand, end), needed = std::min(stop + 1, end);
    convert(rows, converted, needed);
    converted = needed;
    const auto between = Clock::now();
    smooth_rows(begin, stop, planes);
    const auto done = Clock::now();
    converting_ += between - time;
    smoothing_ += done - between;
    time = done;
  }
}

}  // namespace aspect
