// The input that is selected: whether something is connected to it, and its timings where it is
// one like HDMI. The selection itself is nobody's business here.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/capture/camera_fault.h"
#include "runtime/capture/v4l2_calls.h"

namespace aspect {

struct CameraInput {
  std::uint32_t index = 0;
  bool known = false;                         // the driver has such a thing as inputs
  bool digital_video = false;                 // it has timings, which follow the source
  bool asks_timings = false;                  // and they can be found out
  std::uint32_t width_px = 0, height_px = 0;  // of the timings that are set; 0: no timings
  std::uint64_t pixel_clock_hz = 0;
  double rate_hz = 0;
};

// Looks at the input, sets the timings of its source where they are others, subscribes to changes.
CameraFault read_input(V4l2Calls& calls, int descriptor, CameraInput& input);

// Whether the signal is still the one that read_input saw: no_signal where it is gone, stalled
// where it has other timings now. Takes no memory.
CameraFault check_signal(V4l2Calls& calls, int descriptor, const CameraInput& input) noexcept;

// Takes all waiting events; true where the source has changed. Takes no memory.
bool source_changed(V4l2Calls& calls, int descriptor) noexcept;

}  // namespace aspect
