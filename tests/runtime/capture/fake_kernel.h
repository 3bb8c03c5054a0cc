// Cameras in memory behind the calls of a kernel, on a clock that only moves while one waits.
#pragma once

#include <linux/videodev2.h>

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/capture/v4l2_calls.h"

namespace aspect {

struct FakeFormat {
  std::uint32_t fourcc;
  std::vector<std::array<std::uint32_t, 2>> sizes = {{640, 480}};
  std::optional<v4l2_frmsize_stepwise> range{};
  double rate_max_hz = 30;
};

struct FakeControl {
  std::uint32_t id;
  std::string name;
  std::uint32_t type = V4L2_CTRL_TYPE_INTEGER;
  std::int64_t least = 0, most = 255, value = 0;
  std::uint32_t flags = 0;
  std::uint32_t automatic = 0;       // while that control is not 0, this one is inactive
  std::int64_t rounding = 1;         // the driver keeps multiples only
  int refusal = 0;                   // errno of setting it
  std::vector<std::string> items{};  // of a menu; empty: that number is none
};

struct FakeCamera {
  // What it is.
  std::string driver = "fake", card = "Fake camera", bus = "usb-0000:01:00.0-1";
  std::uint32_t abilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  std::vector<FakeFormat> formats = {{V4L2_PIX_FMT_YUYV}};
  std::vector<FakeControl> controls;
  std::uint32_t gap_bytes = 0;  // after each row
  std::uint32_t colorspace = V4L2_COLORSPACE_SRGB, encoding = 0, quantization = 0;
  bool has_inputs = false, digital_video = false;
  std::uint32_t priority = V4L2_PRIORITY_DEFAULT;
  bool has_priorities = true;
  std::uint32_t stamp_flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;

  // What is wrong with it.
  std::map<unsigned long, std::deque<int>> errors;  // of the next calls, by request
  bool disconnected = false;  // until the last descriptor is closed, as with vivid
  bool unplugged = false;     // until it is said otherwise
  bool taken = false;         // by another process
  bool silent = false;        // no frame, no error
  bool lies = false;          // answers S_FMT with what it was asked for
  bool broken = false;        // EIO until the stream ends
  std::uint32_t input_status = 0;
  int query_error = 0;  // of the timings
  bool event = false, subscribed = false;
  int lose_next = 0, flag_next = 0, shorten_next = 0;
  std::uint32_t data_offset = 0;
  std::function<void(v4l2_format&)> spoil_format;
  std::function<void(v4l2_buffer&)> spoil_query, spoil_buffer;
  std::uint32_t granted_buffers = 0;  // 0: as many as are asked for

  // How it is.
  v4l2_format format{};
  v4l2_bt_timings source{}, timings{};
  double rate_hz = 30;
  bool rate_fixed = false;
  std::uint32_t sequence = 0;
  std::uint64_t produced = 0;
  int descriptors = 0;

  struct Buffer {
    std::array<std::vector<std::uint8_t>, 2> memory;
    v4l2_buffer done{};
    bool queued = false;
  };
  std::vector<Buffer> buffers;
  std::vector<std::uint32_t> queued, done;
  bool streaming = false;
  V4l2Calls::Time next_frame{};

  bool multiplanar() const { return (abilities & V4L2_CAP_VIDEO_CAPTURE_MPLANE) != 0; }
  std::uint32_t planes() const;
  std::uint32_t plane_bytes(std::uint32_t plane) const;
};

class FakeKernel final : public V4l2Calls {
 public:
  std::map<std::string, FakeCamera*> nodes;  // by path
  std::map<std::string, int> open_errors;
  int wake_descriptor = -1;
  bool awake = false;
  int maps = 0, polls = 0, ioctls = 0, opens = 0;
  Time time{std::chrono::seconds(100)};

  // Happens while somebody waits.
  void later(std::chrono::milliseconds when, std::function<void()> action);
  void advance(Time until);

  int open(const char* path) noexcept override;
  void close(int descriptor) noexcept override;
  int ioctl(int descriptor, unsigned long request, void* argument) noexcept override;
  void poll(std::span<pollfd> descriptors, Time until) noexcept override;
  std::uint8_t* map(int descriptor, std::size_t bytes, std::uint32_t offset) noexcept override;
  void unmap(std::uint8_t* memory, std::size_t bytes) noexcept override;
  Time now() noexcept override { return time; }

 private:
  struct Action {
    Time when;
    std::function<void()> what;
  };
  short ready(const FakeCamera& camera) const;
  Time next_change(Time until) const;

  std::map<int, FakeCamera*> open_;
  int next_descriptor_ = 3;
  std::deque<Action> actions_;
};

// What the camera answers; 0 or errno.
int fake_ioctl(FakeCamera& camera, unsigned long request, void* argument);
// The part of it that is about controls, inputs and events.
int fake_control_ioctl(FakeCamera& camera, unsigned long request, void* argument);

// The next frame comes at its time; byte 0 of it is the sequence's.
void fake_frame(FakeCamera& camera, V4l2Calls::Time time);

}  // namespace aspect
