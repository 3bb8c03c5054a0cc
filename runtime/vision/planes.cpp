#include "runtime/vision/planes.h"

#include <algorithm>

namespace aspect {
namespace {

Box clipped(const Box& box, int width, int height) {
  const int x0 = std::clamp(box.x, 0, width), y0 = std::clamp(box.y, 0, height);
  const int x1 = std::clamp(box.x + box.width, 0, width);
  const int y1 = std::clamp(box.y + box.height, 0, height);
  return {x0, y0, x1 - x0, y1 - y0};
}

// Interpolation carries brightness one pixel further.
int margin_px(PixelFormat format) {
  constexpr int kMargin_px = 2;
  return is_bayer(format) ? kMargin_px + 1 : kMargin_px;
}

// The first pixel from x to `end` that may be bright by itself, or `end`.
int first_bright(const PixelRows& rows, std::uint8_t least, int y, int x, int end) {
  if (x >= end || !rows.may_reach(least, y, x, end - x)) return end;
  if (end - x == 1) return x;
  const int middle = x + (end - x) / 2;
  const int first = first_bright(rows, least, y, x, middle);
  return first < middle ? first : first_bright(rows, least, y, middle, end);
}

// One behind the last such pixel, or x.
int end_of_bright(const PixelRows& rows, std::uint8_t least, int y, int x, int end) {
  if (x >= end || !rows.may_reach(least, y, x, end - x)) return x;
  if (end - x == 1) return end;
  const int middle = x + (end - x) / 2;
  const int last = end_of_bright(rows, least, y, middle, end);
  return last > middle ? last : end_of_bright(rows, least, y, x, middle);
}

}  // namespace

Box part_looked_at(const Frame& frame, const VisionParameters& parameters) {
  const Box whole{0, 0, frame.width_px, frame.height_px};
  return parameters.region_of_interest.empty()
             ? whole
             : clipped(parameters.region_of_interest, frame.width_px, frame.height_px);
}

Planes take_planes(Arena& arena, int width_px, int height_px) {
  const auto pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  Planes planes;
  planes.red = arena.take<std::uint8_t>(pixels);
  planes.green = arena.take<std::uint8_t>(pixels);
  planes.blue = arena.take<std::uint8_t>(pixels);
  planes.stride_px = width_px;
  return planes;
}

Planes take_grey_planes(Arena& arena, int width_px, int height_px) {
  const auto pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  const std::span<std::uint8_t> grey = arena.take<std::uint8_t>(pixels);
  return {grey, grey, grey, width_px, {}};
}

Box foreground_box(const Frame& frame, const VisionParameters& parameters) {
  const PixelRows rows(frame);
  const Box roi = part_looked_at(frame, parameters);
  // A pixel that reaches the sum has at least one channel that reaches a third of it.
  const auto least =
      static_cast<std::uint8_t>(std::clamp((parameters.intensity_min + 2) / 3, 0, 255));
  int left = roi.x + roi.width, right = roi.x, top = roi.y + roi.height, bottom = roi.y;
  for (int y = roi.y; y < roi.y + roi.height; ++y) {
    if (!rows.may_reach(least, y, roi.x, roi.width)) continue;
    top = std::min(top, y);
    bottom = y + 1;
    // Most rows reach no farther than those before.
    left = first_bright(rows, least, y, roi.x, left);
    right = end_of_bright(rows, least, y, right, roi.x + roi.width);
  }
  if (top >= bottom || left >= right) return {};
  const int margin = margin_px(frame.format);
  const int x0 = std::max(left - margin, roi.x), y0 = std::max(top - margin, roi.y);
  const int x1 = std::min(right + margin, roi.x + roi.width);
  const int y1 = std::min(bottom + margin, roi.y + roi.height);
  return {x0, y0, x1 - x0, y1 - y0};
}

}  // namespace aspect
