// A picture that somebody else owns.
#pragma once

#include <cstddef>
#include <cstdint>

namespace aspect {

enum class PixelFormat : std::uint8_t {
  rgb8,     // 8 bits a channel, interleaved
  bgr8,     // the same, blue first
  rgbx8,    // 32 bits a pixel, of which the fourth byte is not looked at
  bgrx8,    // the same, blue first
  grey8,    // one channel of 8 bits
  depth16,  // distance along the camera's z axis in steps of a fixed length; 16 bits, the machine's
            // byte order; 0 and 65535: nothing measured
  label16,  // number of the surface that is seen, 0: none; 16 bits likewise
  yuyv8,    // 4:2:2, two pixels as Y U Y V; even width
  uyvy8,    // the same as U Y V Y
  nv12,     // 4:2:0, a plane of Y, then one of U V pairs, half as many rows; even width and height
  nv21,     // the same with V U pairs
  bayer_rggb8,  // one channel a pixel behind a colour filter; the letters are those of the first
  bayer_grbg8,  // two pixels of the first two rows; even width and height
  bayer_gbrg8,
  bayer_bggr8,
};

// How Y, U and V were made of R, G and B.
enum class YuvMatrix : std::uint8_t { bt601, bt709, bt2020 };
struct YuvCoding {
  YuvMatrix matrix = YuvMatrix::bt601;
  bool full_range = false;  // Y of 0..255 instead of 16..235
  friend bool operator==(const YuvCoding&, const YuvCoding&) = default;
};

// Of the first plane.
constexpr int bytes_per_pixel(PixelFormat format) {
  switch (format) {
    case PixelFormat::rgb8:
    case PixelFormat::bgr8:
      return 3;
    case PixelFormat::rgbx8:
    case PixelFormat::bgrx8:
      return 4;
    case PixelFormat::grey8:
    case PixelFormat::nv12:
    case PixelFormat::nv21:
    case PixelFormat::bayer_rggb8:
    case PixelFormat::bayer_grbg8:
    case PixelFormat::bayer_gbrg8:
    case PixelFormat::bayer_bggr8:
      return 1;
    case PixelFormat::depth16:
    case PixelFormat::label16:
    case PixelFormat::yuyv8:
    case PixelFormat::uyvy8:
      return 2;
  }
  return 0;
}

constexpr bool is_bayer(PixelFormat format) {
  return format == PixelFormat::bayer_rggb8 || format == PixelFormat::bayer_grbg8 ||
         format == PixelFormat::bayer_gbrg8 || format == PixelFormat::bayer_bggr8;
}

constexpr bool has_chroma_plane(PixelFormat format) {
  return format == PixelFormat::nv12 || format == PixelFormat::nv21;
}

// Y, U and V, of which two pixels or four share the latter.
constexpr bool is_yuv(PixelFormat format) {
  return format == PixelFormat::yuyv8 || format == PixelFormat::uyvy8 || has_chroma_plane(format);
}

// Pixels that share something come in pairs of columns, or of rows as well.
constexpr bool has_even_width(PixelFormat format) {
  return is_yuv(format) || is_bayer(format);
}
constexpr bool has_even_height(PixelFormat format) {
  return has_chroma_plane(format) || is_bayer(format);
}

struct Frame {
  const std::uint8_t* data = nullptr;
  int width_px = 0;
  int height_px = 0;
  std::ptrdiff_t stride_bytes = 0;  // from one row to the next
  PixelFormat format = PixelFormat::rgb8;
  const std::uint8_t* chroma = nullptr;    // the second plane of nv12 and nv21
  std::ptrdiff_t chroma_stride_bytes = 0;  // from one of its rows to the next
  YuvCoding yuv{};                         // of the formats with Y, U and V
};

// Pixels [x, x + width) x [y, y + height).
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
  bool empty() const { return width <= 0 || height <= 0; }
  friend bool operator==(const Box&, const Box&) = default;
};

}  // namespace aspect
