// Why a camera cannot go on, by what is to be done about it.
#pragma once

#include <array>
#include <string_view>

#include "runtime/capture/camera.h"

namespace aspect {

// The state names the remedy: absent: look for it again; busy and failed: open it again later;
// no_signal: keep it open and wait; stalled: start the stream anew. Takes no memory.
struct [[nodiscard]] CameraFault {
  CameraState state = CameraState::streaming;  // which is no fault
  std::array<char, 240> reason{};              // one line

  explicit operator bool() const { return state != CameraState::streaming; }
  std::string_view text() const { return reason.data(); }
};

[[gnu::format(printf, 2, 3)]] CameraFault camera_fault(CameraState state, const char* format,
                                                       ...) noexcept;

// Of a call that failed with `error`, an errno.
CameraFault call_fault(const char* call, int error) noexcept;

}  // namespace aspect
