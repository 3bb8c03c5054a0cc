// What V4L2 calls pixel formats, which of them we read, and which of several is best.
#pragma once

#include <linux/videodev2.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "runtime/capture/camera_settings.h"
#include "runtime/vision/frame.h"

namespace aspect {

struct CameraFormat {
  std::uint32_t fourcc = 0;
  PixelFormat pixels = PixelFormat::rgb8;
  int planes = 1;        // pieces of memory
  bool decoded = false;  // not ours: goes through the decoder and comes out as rgb8
  int cost = 0;          // place among all, the cheapest first
};

// None where neither we nor the decoder (if there is one) make frames for such a sensor of it.
std::optional<CameraFormat> camera_format(std::uint32_t fourcc, SensorKind sensor, bool decoder);

// One of the camera's formats at the size nearest to what is wanted.
struct FormatOffer {
  CameraFormat format;
  int width_px = 0, height_px = 0;
  double rate_max_hz = 0;  // 0: not known
};

// The format asked for by name, where it is offered; then the nearest size, then a sufficient rate,
// then the least cost. `offers` is not empty.
std::size_t best_offer(std::span<const FormatOffer> offers, const CameraSettings& settings);

// How far a size is from the wanted one. Sums of pixels in width and height.
std::int64_t size_distance(std::int64_t width_px, std::int64_t height_px,
                           const CameraSettings& settings);

// Nearest to `wanted` within a range that a driver gave, however odd; none where it is empty.
std::optional<std::uint32_t> nearest_step(std::uint32_t least, std::uint32_t most,
                                          std::uint32_t step, int wanted);

// V4L2's fields with its rules for those left at their default.
YuvCoding yuv_coding(std::uint32_t colorspace, std::uint32_t encoding, std::uint32_t quantization);

// What a stream was agreed to be, checked.
struct StreamFormat {
  CameraFormat format;
  v4l2_buf_type buffer_type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  int width_px = 0, height_px = 0;  // even where the format needs it: what is odd is cut off
  std::uint32_t stride_bytes[2] = {0, 0};
  YuvCoding yuv{};
  v4l2_pix_format picture{};  // as the decoder wants to know it

  bool multiplanar() const { return buffer_type == V4L2_BUF_TYPE_VIDEO_CAPTURE_MPLANE; }
};

// One line where it cannot be read safely. Fills in sizes and strides.
std::optional<std::string> take_format(const v4l2_format& agreed, const CameraFormat& format,
                                       StreamFormat& stream);

// The least bytes that piece `plane` of a whole frame has; 0 where the decoder judges.
std::uint64_t frame_bytes(const StreamFormat& stream, int plane);

}  // namespace aspect
