// A picture that somebody else owns.
#pragma once

#include <cstddef>
#include <cstdint>

namespace aspect {

enum class PixelFormat : std::uint8_t {
  rgb8,     // 8 bits a channel, interleaved
  bgr8,     // the same, blue first
  grey8,    // one channel of 8 bits
  depth16,  // distance along the camera's z axis in steps of a fixed length; 16 bits, the machine's
            // byte order; 0 and 65535: nothing measured
  label16,  // number of the surface that is seen, 0: none; 16 bits likewise
};

constexpr int bytes_per_pixel(PixelFormat format) {
  switch (format) {
    case PixelFormat::rgb8:
    case PixelFormat::bgr8:
      return 3;
    case PixelFormat::grey8:
      return 1;
    case PixelFormat::depth16:
    case PixelFormat::label16:
      return 2;
  }
  return 0;
}

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
