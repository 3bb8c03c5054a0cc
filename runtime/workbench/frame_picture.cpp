#include "runtime/workbench/frame_picture.h"

#include <algorithm>
#include <cstring>

namespace aspect {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr std::size_t kBmpHeader = 54;

std::size_t row_bytes(int width_px) {
  return (static_cast<std::size_t>(width_px) * 3 + 3) / 4 * 4;
}

std::uint8_t clamped(int value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

// In 1/1024: what V adds to red, U and V take from green, U adds to blue (ITU-R BT.601, 709, 2020).
Rgb of_yuv(int y, int u, int v, const YuvCoding& coding) {
  static constexpr std::array<std::array<int, 4>, 3> kMatrix = {
      {{1436, 352, 731, 1815}, {1613, 192, 479, 1900}, {1510, 168, 585, 1927}}};
  const auto& [red, green_u, green_v, blue] = kMatrix[static_cast<std::size_t>(coding.matrix)];
  // Of the 255 steps, Y has 219 and the others 224 unless they have all.
  const int luma = coding.full_range ? y * 1024 : (y - 16) * 1192;
  const int scale = coding.full_range ? 1024 : 1166;
  const int u_centred = (u - 128) * scale / 1024, v_centred = (v - 128) * scale / 1024;
  return {clamped((luma + red * v_centred) / 1024),
          clamped((luma - green_u * u_centred - green_v * v_centred) / 1024),
          clamped((luma + blue * u_centred) / 1024)};
}

// Place of red in the 2 x 2 cell; blue is across.
Rgb of_bayer(const std::uint8_t* upper, const std::uint8_t* lower, PixelFormat format) {
  const std::array<int, 4> cell = {upper[0], upper[1], lower[0], lower[1]};
  const std::size_t red = format == PixelFormat::bayer_rggb8   ? 0
                          : format == PixelFormat::bayer_grbg8 ? 1
                          : format == PixelFormat::bayer_gbrg8 ? 2
                                                               : 3;
  const int green = (cell[red ^ 1U] + cell[red ^ 2U]) / 2;
  return {clamped(cell[red]), clamped(green), clamped(cell[red ^ 3U])};
}

Rgb grey(int value) {
  return {clamped(value), clamped(value), clamped(value)};
}

// Neighbouring numbers get colours far from one another.
Rgb of_label(unsigned label) {
  const unsigned mixed = label * 2654435761U;
  return {static_cast<std::uint8_t>(mixed >> 24U), static_cast<std::uint8_t>(mixed >> 16U),
          static_cast<std::uint8_t>(mixed >> 8U)};
}

void put(std::uint8_t* to, std::uint32_t value, std::size_t bytes) {
  for (std::size_t k = 0; k < bytes; ++k) to[k] = static_cast<std::uint8_t>(value >> (8 * k));
}

}  // namespace

std::array<std::uint8_t, 3> preview_rgb(const Frame& frame, int x, int y) noexcept {
  const std::uint8_t* const row = frame.data + y * frame.stride_bytes;
  const std::uint8_t* const at = row + x * bytes_per_pixel(frame.format);
  const std::uint8_t* const pair = row + (x & ~1) * 2;
  std::uint16_t wide = 0;
  switch (frame.format) {
    case PixelFormat::rgb8:
    case PixelFormat::rgbx8:
      return {at[0], at[1], at[2]};
    case PixelFormat::bgr8:
    case PixelFormat::bgrx8:
      return {at[2], at[1], at[0]};
    case PixelFormat::grey8:
      return grey(at[0]);
    case PixelFormat::depth16:
      std::memcpy(&wide, at, sizeof wide);
      return grey(wide / 256);
    case PixelFormat::label16:
      std::memcpy(&wide, at, sizeof wide);
      return of_label(wide);
    case PixelFormat::yuyv8:
      return of_yuv(at[0], pair[1], pair[3], frame.yuv);
    case PixelFormat::uyvy8:
      return of_yuv(at[1], pair[0], pair[2], frame.yuv);
    case PixelFormat::nv12:
    case PixelFormat::nv21: {
      const std::uint8_t* const uv = frame.chroma + y / 2 * frame.chroma_stride_bytes + (x & ~1);
      const bool swapped = frame.format == PixelFormat::nv21;
      return of_yuv(at[0], uv[swapped ? 1 : 0], uv[swapped ? 0 : 1], frame.yuv);
    }
    case PixelFormat::bayer_rggb8:
    case PixelFormat::bayer_grbg8:
    case PixelFormat::bayer_gbrg8:
    case PixelFormat::bayer_bggr8: {
      const std::uint8_t* const upper = frame.data + (y & ~1) * frame.stride_bytes + (x & ~1);
      return of_bayer(upper, upper + frame.stride_bytes, frame.format);
    }
  }
  return {};
}

PictureSize size_within(const PictureSize& frame, const PictureSize& bounds) noexcept {
  // The larger of the two quotients, at least 1, is the scale.
  int divisor = 1, dividend = 1;
  if (frame.width_px > bounds.width_px) dividend = frame.width_px, divisor = bounds.width_px;
  if (std::int64_t{frame.height_px} * divisor > std::int64_t{bounds.height_px} * dividend)
    dividend = frame.height_px, divisor = bounds.height_px;
  const auto scaled = [&](int length) {
    return std::max(1, static_cast<int>(std::int64_t{length} * divisor / dividend));
  };
  return {scaled(frame.width_px), scaled(frame.height_px)};
}

std::string bitmap_of(const Frame& frame, const PictureSize& size) {
  const std::size_t row = row_bytes(size.width_px);
  const std::size_t bytes = row * static_cast<std::size_t>(size.height_px);
  std::string bmp(kBmpHeader + bytes, '\0');
  auto* const header = reinterpret_cast<std::uint8_t*>(bmp.data());
  header[0] = 'B', header[1] = 'M';
  put(header + 2, static_cast<std::uint32_t>(kBmpHeader + bytes), 4);
  put(header + 10, kBmpHeader, 4);
  put(header + 14, 40, 4);
  put(header + 18, static_cast<std::uint32_t>(size.width_px), 4);
  put(header + 22, static_cast<std::uint32_t>(-size.height_px), 4);  // from the top down
  put(header + 26, 1, 2);
  put(header + 28, 24, 2);
  put(header + 34, static_cast<std::uint32_t>(bytes), 4);
  for (int y = 0; y < size.height_px; ++y) {
    std::uint8_t* to = header + kBmpHeader + row * static_cast<std::size_t>(y);
    const int from_y = (2 * y + 1) * frame.height_px / (2 * size.height_px);
    for (int x = 0; x < size.width_px; ++x, to += 3) {
      const auto [red, green, blue] =
          preview_rgb(frame, (2 * x + 1) * frame.width_px / (2 * size.width_px), from_y);
      to[0] = blue, to[1] = green, to[2] = red;
    }
  }
  return bmp;
}

}  // namespace aspect
