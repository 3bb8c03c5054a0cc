// A camera that is expected to fail and to come back: unplugged, taken by another process, without
// a signal, silent. One call gives the newest frame or says what is the matter.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/capture/camera_settings.h"
#include "runtime/vision/frame.h"

namespace aspect {

enum class CameraState : std::uint8_t {
  streaming,
  absent,     // no such camera; looked for again and again
  busy,       // another process holds it
  no_signal,  // it is there, but nothing is connected to its input
  stalled,    // it stopped sending; being started anew
  failed,     // it refused something; being opened anew
};
std::string_view name_of(CameraState state);

class V4l2Calls;
struct DeviceFolders;

// What a camera has agreed to.
struct CameraPlan {
  std::string node, driver, card, bus;
  std::string fourcc;
  int width_px = 0, height_px = 0;
  PixelFormat format = PixelFormat::rgb8;  // of the frames handed on
  double rate_hz = 0;                      // 0: it does not say
  bool multiplanar = false, decoded = false;
  std::vector<std::string> controls;  // "exposure = 100", as read back
  std::vector<std::string> warnings;  // what was asked for and not had
};

struct CameraEvent {
  enum class Kind : std::uint8_t {
    frame,    // `frame` and what goes with it
    damaged,  // a frame came, but not whole: flagged by the driver, or too short
    changed,  // another state than before; streaming begins with the first whole frame, which the
              // next call gives, and the plan may be another one, too
    woken,    // wake_descriptor is readable
    nothing,  // the time is over
  } kind = Kind::nothing;
  CameraState state = CameraState::absent;
  std::string_view reason;  // of a damaged frame or a state that is not streaming; one line

  Frame frame;                 // lives until the next call
  std::uint64_t sequence = 0;  // place among all frames that the camera took since its start
  std::uint64_t late = 0;      // frames given up since the last one because a newer one was there
  std::uint64_t lost = 0;      // frames that the driver lost since the last one
  std::chrono::steady_clock::time_point captured;  // when the driver says that it was taken
};

class Camera {
 public:
  explicit Camera(CameraSettings settings);
  // With another kernel than the one that this runs on.
  Camera(CameraSettings settings, V4l2Calls& calls, const DeviceFolders& folders);
  ~Camera();
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  // Opens, negotiates and sets controls, but does not stream: what --check prints. One line where
  // the camera cannot be used now.
  [[nodiscard]] Result<CameraPlan> check();

  // The next thing that happens, at the latest after `timeout`; looks for the camera, opens it and
  // starts it as often as needed. While streaming it allocates nothing and makes no system calls
  // but poll and those of V4L2; only a decoder, if the plan has one, takes memory with its first
  // frames. wake_descriptor: -1, or what else to wait for; it comes before frames.
  [[nodiscard]] CameraEvent next(std::chrono::milliseconds timeout, int wake_descriptor) noexcept;

  // Somebody else has set the controls so: from now on they are what is set when the camera is
  // started anew.
  void adopt_controls(const std::vector<CameraControl>& controls);

  // Of the last time that it was streaming.
  [[nodiscard]] const CameraPlan& plan() const;

 private:
  class Link;
  std::unique_ptr<Link> link_;
};

}  // namespace aspect
