#include "runtime/vision/planes.h"

#include <algorithm>

namespace aspect {
namespace {

const std::uint8_t* row_of(const Frame& frame, int y) {
  return frame.data + y * frame.stride_bytes;
}

// 64 pixels at a time: a plain maximum that compilers turn into vector code.
bool any_at_least(const std::uint8_t* bytes, int count, std::uint8_t least) {
  constexpr int kChunk = 192;
  int i = 0;
  for (; i + kChunk <= count; i += kChunk) {
    std::uint8_t highest = 0;
    for (int k = 0; k < kChunk; ++k) highest = std::max(highest, bytes[i + k]);
    if (highest >= least) return true;
  }
  for (; i < count; ++i)
    if (bytes[i] >= least) return true;
  return false;
}

Box clipped(const Box& box, int width, int height) {
  const int x0 = std::clamp(box.x, 0, width), y0 = std::clamp(box.y, 0, height);
  const int x1 = std::clamp(box.x + box.width, 0, width);
  const int y1 = std::clamp(box.y + box.height, 0, height);
  return {x0, y0, x1 - x0, y1 - y0};
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

Box foreground_box(const Frame& frame, const VisionParameters& parameters) {
  const Box roi = part_looked_at(frame, parameters);
  // A pixel that reaches the sum has at least one channel that reaches a third of it.
  const int channels = bytes_per_pixel(frame.format);
  const auto least =
      static_cast<std::uint8_t>(std::clamp((parameters.intensity_min + 2) / 3, 0, 255));
  int left = roi.x + roi.width, right = roi.x, top = roi.y + roi.height, bottom = roi.y;
  for (int y = roi.y; y < roi.y + roi.height; ++y) {
    const std::uint8_t* row = row_of(frame, y);
    if (!any_at_least(row + channels * roi.x, channels * roi.width, least)) continue;
    top = std::min(top, y);
    bottom = y + 1;
    const auto bright = [&](int x) { return any_at_least(row + channels * x, channels, least); };
    for (int x = roi.x; x < left; ++x)
      if (bright(x)) left = x;
    for (int x = roi.x + roi.width; x > right; --x)
      if (bright(x - 1)) right = x;
  }
  if (top >= bottom || left >= right) return {};
  constexpr int kMargin_px = 2;
  const int x0 = std::max(left - kMargin_px, roi.x), y0 = std::max(top - kMargin_px, roi.y);
  const int x1 = std::min(right + kMargin_px, roi.x + roi.width);
  const int y1 = std::min(bottom + kMargin_px, roi.y + roi.height);
  return {x0, y0, x1 - x0, y1 - y0};
}

Planes take_grey_planes(Arena& arena, int width_px, int height_px) {
  const auto pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  const std::span<std::uint8_t> grey = arena.take<std::uint8_t>(pixels);
  return {grey, grey, grey, width_px, {}};
}

void copy_grey(const Frame& frame, const Box& box, Planes& planes) {
  planes.active = box;
  for (int y = box.y; y < box.y + box.height; ++y)
    std::copy_n(row_of(frame, y) + box.x, box.width,
                planes.red.data() + y * planes.stride_px + box.x);
}

void split_planes(const Frame& frame, const Box& box, Planes& planes) {
  planes.active = box;
  const bool bgr = frame.format == PixelFormat::bgr8;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::uint8_t* pixel = row_of(frame, y) + 3 * box.x;
    const auto offset = static_cast<std::size_t>(y * planes.stride_px + box.x);
    std::uint8_t* first = (bgr ? planes.blue : planes.red).data() + offset;
    std::uint8_t* second = planes.green.data() + offset;
    std::uint8_t* third = (bgr ? planes.red : planes.blue).data() + offset;
    for (int x = 0; x < box.width; ++x) {
      first[x] = pixel[3 * x];
      second[x] = pixel[3 * x + 1];
      third[x] = pixel[3 * x + 2];
    }
  }
}

}  // namespace aspect
