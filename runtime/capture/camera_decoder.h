// Formats that are not ours, JPEG above all, through libv4lconvert. It takes memory of its own
// with the first frames.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/capture/camera_formats.h"
#include "runtime/capture/v4l2_calls.h"

namespace aspect {

class CameraDecoder {
 public:
  // Whether this build has one.
  static bool available();

  CameraDecoder();
  ~CameraDecoder();
  CameraDecoder(const CameraDecoder&) = delete;
  CameraDecoder& operator=(const CameraDecoder&) = delete;

  // Takes the memory for a frame. The descriptor must stay open until close. False where it cannot.
  bool open(V4l2Calls& calls, int descriptor, const StreamFormat& format);
  void close() noexcept;

  // False where the bytes are no frame. The frame lives until the next call.
  bool decode(std::span<const std::uint8_t> bytes, Frame& frame) noexcept;

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace aspect
