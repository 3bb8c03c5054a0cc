#include "runtime/capture/camera_input.h"

#include <linux/videodev2.h>

#include <cerrno>

namespace aspect {
namespace {

constexpr std::uint32_t kNothingThere = V4L2_IN_ST_NO_POWER | V4L2_IN_ST_NO_SIGNAL |
                                        V4L2_IN_ST_NO_H_LOCK | V4L2_IN_ST_NO_V_LOCK |
                                        V4L2_IN_ST_NO_SYNC | V4L2_IN_ST_NO_CARRIER;

CameraFault status_fault(std::uint32_t status) noexcept {
  if ((status & kNothingThere) == 0) return {};
  const bool unsteady = (status & (V4L2_IN_ST_NO_POWER | V4L2_IN_ST_NO_SIGNAL)) == 0;
  return camera_fault(CameraState::no_signal, "%s",
                      unsteady ? "the input cannot lock to its signal" : "the input has no signal");
}

// The timings of the source. `asks` is false where the driver cannot find them out.
CameraFault query_timings(V4l2Calls& calls, int descriptor, v4l2_dv_timings& timings,
                          bool& asks) noexcept {
  timings = {};
  const int error = calls.ioctl(descriptor, VIDIOC_QUERY_DV_TIMINGS, &timings);
  // Some cannot look while they stream.
  asks = error != ENOTTY && error != ENODATA && error != EINVAL && error != EBUSY;
  if (!asks) return {};
  switch (error) {
    case 0:
      return {};
    case ENOLINK:
      return camera_fault(CameraState::no_signal, "the input has no signal");
    case ENOLCK:
      return camera_fault(CameraState::no_signal, "the input cannot lock to its signal");
    case ERANGE:
      return camera_fault(CameraState::no_signal,
                          "the input's signal is beyond what the device can take");
    default:
      return call_fault("VIDIOC_QUERY_DV_TIMINGS", error);
  }
}

// Measured clocks are never quite the nominal ones.
bool alike(std::uint64_t a_hz, std::uint64_t b_hz) noexcept {
  const std::uint64_t difference = a_hz > b_hz ? a_hz - b_hz : b_hz - a_hz;
  return difference <= a_hz / 200;
}

bool alike(const v4l2_bt_timings& a, const v4l2_bt_timings& b) noexcept {
  return a.width == b.width && a.height == b.height && a.interlaced == b.interlaced &&
         alike(a.pixelclock, b.pixelclock);
}

CameraFault follow_timings(V4l2Calls& calls, int descriptor, CameraInput& input) {
  v4l2_dv_timings source{}, set{};
  if (CameraFault fault = query_timings(calls, descriptor, source, input.asks_timings))
    return fault;
  const bool has_set = calls.ioctl(descriptor, VIDIOC_G_DV_TIMINGS, &set) == 0;
  if (input.asks_timings && (!has_set || !alike(source.bt, set.bt))) {
    set = source;
    const int error = calls.ioctl(descriptor, VIDIOC_S_DV_TIMINGS, &set);
    if (error != 0 && error != ENOTTY) return call_fault("VIDIOC_S_DV_TIMINGS", error);
  }
  input.width_px = set.bt.width;
  input.height_px = set.bt.height;
  input.pixel_clock_hz = set.bt.pixelclock;
  const v4l2_bt_timings* bt = &set.bt;
  const double frame_pixels =
      static_cast<double>(V4L2_DV_BT_FRAME_WIDTH(bt)) * V4L2_DV_BT_FRAME_HEIGHT(bt);
  if (frame_pixels > 0) input.rate_hz = static_cast<double>(bt->pixelclock) / frame_pixels;
  return {};
}

}  // namespace

CameraFault read_input(V4l2Calls& calls, int descriptor, CameraInput& input) {
  input = {};
  int index = 0;
  if (calls.ioctl(descriptor, VIDIOC_G_INPUT, &index) != 0 || index < 0) return {};
  v4l2_input answer{};
  answer.index = static_cast<std::uint32_t>(index);
  const int error = calls.ioctl(descriptor, VIDIOC_ENUMINPUT, &answer);
  if (error == ENODEV) return call_fault("VIDIOC_ENUMINPUT", error);
  if (error != 0) return {};
  input.index = static_cast<std::uint32_t>(index);
  input.known = true;
  input.digital_video = (answer.capabilities & V4L2_IN_CAP_DV_TIMINGS) != 0;

  v4l2_event_subscription subscription{};
  subscription.type = V4L2_EVENT_SOURCE_CHANGE;
  subscription.id = input.index;
  // Without it the signal is only looked at once a second.
  static_cast<void>(calls.ioctl(descriptor, VIDIOC_SUBSCRIBE_EVENT, &subscription));

  if (CameraFault fault = status_fault(answer.status)) return fault;
  return input.digital_video ? follow_timings(calls, descriptor, input) : CameraFault{};
}

CameraFault check_signal(V4l2Calls& calls, int descriptor, const CameraInput& input) noexcept {
  if (!input.known) return {};
  v4l2_input answer{};
  answer.index = input.index;
  if (const int error = calls.ioctl(descriptor, VIDIOC_ENUMINPUT, &answer); error != 0)
    return call_fault("VIDIOC_ENUMINPUT", error);
  if (CameraFault fault = status_fault(answer.status)) return fault;
  if (!input.asks_timings) return {};
  v4l2_dv_timings source;
  bool asks = false;
  if (CameraFault fault = query_timings(calls, descriptor, source, asks)) return fault;
  if (!asks || (source.bt.width == input.width_px && source.bt.height == input.height_px &&
                alike(source.bt.pixelclock, input.pixel_clock_hz)))
    return {};
  return camera_fault(CameraState::stalled, "the input's signal has changed");
}

bool source_changed(V4l2Calls& calls, int descriptor) noexcept {
  constexpr int kMaxEvents = 64;
  bool changed = false;
  v4l2_event event{};
  for (int k = 0; k < kMaxEvents; ++k) {
    if (calls.ioctl(descriptor, VIDIOC_DQEVENT, &event) != 0) break;
    changed = changed || event.type == V4L2_EVENT_SOURCE_CHANGE;
    if (event.pending == 0) break;
  }
  return changed;
}

}  // namespace aspect
