#include "runtime/c_interface/plain_frame.h"

#include <array>
#include <cstring>

#include "runtime/vision/pixel_rows.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

constexpr std::array kFormats = {
    PixelFormat::rgb8,        PixelFormat::bgr8,        PixelFormat::rgbx8,
    PixelFormat::bgrx8,       PixelFormat::grey8,       PixelFormat::depth16,
    PixelFormat::label16,     PixelFormat::yuyv8,       PixelFormat::uyvy8,
    PixelFormat::nv12,        PixelFormat::nv21,        PixelFormat::bayer_rggb8,
    PixelFormat::bayer_grbg8, PixelFormat::bayer_gbrg8, PixelFormat::bayer_bggr8};
static_assert(kFormats[ASPECT_BAYER_BGGR8] == PixelFormat::bayer_bggr8 &&
              kFormats[ASPECT_YUYV8] == PixelFormat::yuyv8);

// An enumeration of C holds whatever number it is given; C++ may not load another one as such.
template <typename Enumeration>
std::size_t number_of(const Enumeration& value) {
  static_assert(sizeof value == sizeof(unsigned));
  unsigned number = 0;
  std::memcpy(&number, &value, sizeof number);
  return number;
}

}  // namespace

CheckedFrame checked_frame(const aspect_frame& given, SensorKind sensor) noexcept {
  const int width = given.width_px, height = given.height_px;
  const std::size_t format = number_of(given.format), matrix = number_of(given.yuv_matrix);
  if (given.data == nullptr) return {ASPECT_BAD_ARGUMENT, {}};
  if (width < 1 || height < 1 || width > kMaxFrameSide_px || height > kMaxFrameSide_px ||
      width * height > kMaxFramePixels)
    return {ASPECT_WRONG_SIZE, {}};
  if (format >= kFormats.size() || matrix > ASPECT_BT2020 || !gives(sensor, kFormats[format]))
    return {ASPECT_WRONG_FORMAT, {}};
  Frame frame;
  frame.data = static_cast<const std::uint8_t*>(given.data);
  frame.width_px = width;
  frame.height_px = height;
  frame.format = kFormats[format];
  const std::ptrdiff_t row = std::ptrdiff_t{width} * bytes_per_pixel(frame.format);
  frame.stride_bytes = given.stride_bytes == 0 ? row : given.stride_bytes;
  if (frame.stride_bytes < row && frame.stride_bytes > -row) return {ASPECT_BAD_ARGUMENT, {}};
  frame.yuv = {static_cast<YuvMatrix>(matrix), given.yuv_full_range != 0};
  if (has_chroma_plane(frame.format)) {
    frame.chroma_stride_bytes =
        given.chroma_stride_bytes == 0 ? frame.stride_bytes : given.chroma_stride_bytes;
    if (frame.chroma_stride_bytes < row && frame.chroma_stride_bytes > -row)
      return {ASPECT_BAD_ARGUMENT, {}};
    frame.chroma = static_cast<const std::uint8_t*>(given.chroma);
    // Behind rows that go up there is no such place.
    if (frame.chroma == nullptr && frame.stride_bytes < 0) return {ASPECT_BAD_ARGUMENT, {}};
    if (frame.chroma == nullptr) frame.chroma = frame.data + frame.stride_bytes * height;
  }
  if (!is_whole(frame)) return {ASPECT_WRONG_SIZE, {}};
  return {ASPECT_OK, frame};
}

}  // namespace aspect
