// Buffers that the driver fills, shared with it.
#pragma once

#include <linux/videodev2.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/capture/camera_fault.h"
#include "runtime/capture/camera_formats.h"
#include "runtime/capture/v4l2_calls.h"

namespace aspect {

struct StreamFrame {
  Frame frame;                          // of formats that need no decoder
  std::span<const std::uint8_t> bytes;  // what the driver wrote into the first piece of memory
  std::uint64_t late = 0, lost = 0;     // since the last one taken
  std::uint64_t step = 1;               // from the last one taken to this one in the sequence
  std::chrono::steady_clock::time_point captured;
};

// Nothing but start takes memory or calls anything but ioctl and the clock.
class CameraStream {
 public:
  static constexpr std::uint32_t kBuffers = 4;

  explicit CameraStream(V4l2Calls& calls) : calls_(calls) {}
  ~CameraStream() { stop(); }
  CameraStream(const CameraStream&) = delete;
  CameraStream& operator=(const CameraStream&) = delete;

  // Takes buffers and hands them to the driver. After a fault stop is still due.
  CameraFault prepare(int descriptor, const StreamFormat& format);
  CameraFault start() noexcept;

  // Gives everything back, whatever was there. The descriptor must still be open.
  void stop() noexcept;

  // Takes whatever waits and keeps only the newest. Whole frames and damaged ones both count as
  // signs of life. `damage` is why the last one taken is no good, null where there is none.
  CameraFault drain(const char*& damage) noexcept;

  bool has_frame() const { return newest_ >= 0; }

  // Only if has_frame(). Lives until release.
  StreamFrame take() noexcept;

  // The frame last taken goes back to the driver.
  CameraFault release() noexcept;

 private:
  struct Plane {
    std::uint8_t* memory = nullptr;
    std::size_t bytes = 0;
  };
  struct Buffer {
    std::array<Plane, 2> planes{};
    std::array<std::uint32_t, 2> begin{}, end{};  // of what the driver wrote
    bool queued = false;
    std::chrono::steady_clock::time_point captured;
  };

  CameraFault map_buffer(std::uint32_t index);
  CameraFault queue(std::uint32_t index) noexcept;
  const char* damage_of(const v4l2_buffer& answer, std::span<const v4l2_plane> planes,
                        Buffer& buffer) const noexcept;
  void count(std::uint32_t sequence) noexcept;
  std::chrono::steady_clock::time_point capture_time(const v4l2_buffer& answer) noexcept;

  V4l2Calls& calls_;
  StreamFormat format_;
  int descriptor_ = -1;
  std::array<Buffer, VIDEO_MAX_FRAME> buffers_{};
  std::uint32_t buffer_count_ = 0;
  int newest_ = -1, taken_ = -1;  // dequeued; -1: none
  std::uint64_t late_ = 0, lost_ = 0, step_ = 0;
  std::optional<std::uint32_t> sequence_;
};

}  // namespace aspect
