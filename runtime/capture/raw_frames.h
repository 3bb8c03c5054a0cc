// Recorded camera frames in the camera's own format: files named NAME.WIDTHxHEIGHT.FOURCC, as
// clip.640x480.YUYV, that hold one frame after the other without gaps, as
// `v4l2-ctl --stream-to` and ffmpeg's rawvideo write them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "runtime/base/input_file.h"
#include "runtime/base/result.h"
#include "runtime/capture/frame_source.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

struct RawFormat {
  int width_px = 0, height_px = 0;
  PixelFormat format = PixelFormat::rgb8;
};

// A name that ends like .WIDTHxHEIGHT.XXXX, whether it makes sense or not, or in one of the four
// characters known: YUYV UYVY NV12 NV21 RGB3 BGR3 GREY RGGB GRBG GBRG BA81 (V4L2's).
bool is_raw_name(const std::filesystem::path& file);

// Why a raw name is no good, or what it says.
Result<RawFormat> raw_format_of(const std::filesystem::path& file);

// How many frames the file has; 1, the failed one, where it cannot be used.
std::size_t raw_frame_count(const std::filesystem::path& file);

// YUV is taken for BT.601 of limited range, which V4L2 calls the default.
class RawFrames : public FrameSource {
 public:
  RawFrames(std::filesystem::path file, SensorKind sensor);

  // Frames are named FILE#0, FILE#1 and so on. After a failed frame only the end follows.
  [[nodiscard]] FrameStatus next(CapturedFrame& frame) override;

 private:
  // What is wrong with the file, none: it is open.
  std::optional<std::string> open();

  std::filesystem::path file_;
  SensorKind sensor_;
  std::optional<InputFile> input_;
  RawFormat format_;
  std::uint64_t count_ = 0, next_ = 0;
  bool ended_ = false;
};

}  // namespace aspect
