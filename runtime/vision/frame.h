// A picture that somebody else owns.
#pragma once

#include <cstddef>
#include <cstdint>

namespace aspect {

enum class PixelFormat : std::uint8_t { rgb8, bgr8 };  // 8 bits a channel, interleaved

struct Frame {
  const std::uint8_t* data = nullptr;
  int width_px = 0;
  int height_px = 0;
  std::ptrdiff_t stride_bytes = 0;  // from one row to the next
  PixelFormat format = PixelFormat::rgb8;
};

// Pixels [x, x + width) x [y, y + height).
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  bool empty() const { return width <= 0 || height <= 0; }
  friend bool operator==(const Box&, const Box&) = default;
};

}  // namespace aspect
