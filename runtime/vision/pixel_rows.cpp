#include "runtime/vision/pixel_rows.h"

#include <algorithm>

#include "runtime/vision/bayer_rows.h"

namespace aspect {
namespace {

using Byte = std::uint8_t;

// 64 pixels at a time: a plain maximum that compilers turn into vector code.
bool any_at_least(const Byte* bytes, int count, Byte least) {
  constexpr int kChunk = 192;
  int i = 0;
  for (; i + kChunk <= count; i += kChunk) {
    Byte highest = 0;
    for (int k = 0; k < kChunk; ++k) highest = std::max(highest, bytes[i + k]);
    if (highest >= least) return true;
  }
  for (; i < count; ++i)
    if (bytes[i] >= least) return true;
  return false;
}

template <int kBytes>
void split_row(const Byte* pixel, int count, Byte* __restrict first, Byte* __restrict second,
               Byte* __restrict third) {
  for (int x = 0; x < count; ++x) {
    first[x] = pixel[kBytes * x];
    second[x] = pixel[kBytes * x + 1];
    third[x] = pixel[kBytes * x + 2];
  }
}

}  // namespace

bool is_whole(const Frame& frame) {
  if (frame.data == nullptr) return false;
  if (has_chroma_plane(frame.format) && frame.chroma == nullptr) return false;
  return !(has_even_width(frame.format) && frame.width_px % 2 != 0) &&
         !(has_even_height(frame.format) && frame.height_px % 2 != 0);
}

YuvPairs PixelRows::pairs(int y) const {
  const Byte* luma = row(y);
  switch (frame_.format) {
    case PixelFormat::uyvy8:
      return {luma + 1, 2, luma, luma + 2, 4};
    case PixelFormat::nv12:
    case PixelFormat::nv21: {
      const Byte* chroma = frame_.chroma + y / 2 * frame_.chroma_stride_bytes;
      const int u = frame_.format == PixelFormat::nv12 ? 0 : 1;
      return {luma, 1, chroma + u, chroma + 1 - u, 2};
    }
    default:
      return {luma, 2, luma + 1, luma + 3, 4};
  }
}

void PixelRows::colours(int y, int x, int count, ColourRow out) const {
  const Byte* const pixel = row(y) + x * bytes_per_pixel(frame_.format);
  switch (frame_.format) {
    case PixelFormat::rgb8:
      return split_row<3>(pixel, count, out.red, out.green, out.blue);
    case PixelFormat::bgr8:
      return split_row<3>(pixel, count, out.blue, out.green, out.red);
    case PixelFormat::rgbx8:
      return split_row<4>(pixel, count, out.red, out.green, out.blue);
    case PixelFormat::bgrx8:
      return split_row<4>(pixel, count, out.blue, out.green, out.red);
    default:
      break;
  }
  if (is_bayer(frame_.format)) return bayer_row(frame_, y, x, count, out.red, out.green, out.blue);
  if (is_yuv(frame_.format))
    return yuv_row(pairs(y), factors_, x, count, out.red, out.green, out.blue);
  for (Byte* channel : {out.red, out.green, out.blue}) std::copy_n(pixel, count, channel);
}

void PixelRows::greys(int y, int x, int count, Byte* out) const {
  if (is_yuv(frame_.format)) return luma_row(pairs(y), factors_, x, count, out);
  std::copy_n(row(y) + x, count, out);
}

bool PixelRows::may_reach(Byte least, int y, int x, int count) const {
  if (is_yuv(frame_.format)) return yuv_may_reach(pairs(y), factors_, least, x, count);
  const int channels = bytes_per_pixel(frame_.format);
  return any_at_least(row(y) + channels * x, channels * count, least);
}

}  // namespace aspect
