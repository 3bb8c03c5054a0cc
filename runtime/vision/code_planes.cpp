#include "runtime/vision/code_planes.h"

#include <algorithm>
#include <cstring>

namespace aspect {

CodeMasks take_code_masks(Arena& arena, int width_px, int height_px) {
  const auto pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  CodeMasks masks;
  masks.foreground = arena.take<std::uint8_t>(pixels);
  masks.solid = arena.take<std::uint8_t>(pixels);
  return masks;
}

std::uint16_t number_at(const Frame& frame, int x, int y) {
  std::uint16_t number = 0;
  std::memcpy(&number, frame.data + y * frame.stride_bytes + 2 * x, sizeof number);
  return number;
}

Box box_of_numbers(const Frame& frame, const VisionParameters& parameters, int least, int most) {
  const Box part = part_looked_at(frame, parameters);
  int left = part.x + part.width, right = part.x, top = part.y + part.height, bottom = part.y;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      const int number = number_at(frame, x, y);
      if (number < least || number > most) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = y + 1;
    }
  }
  if (top >= bottom || left >= right) return {};
  constexpr int kMargin_px = 2;
  const int x0 = std::max(left - kMargin_px, part.x), y0 = std::max(top - kMargin_px, part.y);
  const int x1 = std::min(right + kMargin_px, part.x + part.width);
  const int y1 = std::min(bottom + kMargin_px, part.y + part.height);
  return {x0, y0, x1 - x0, y1 - y0};
}

}  // namespace aspect
