// A frame as a caller of aspect.h describes it, checked.
#pragma once

#include <optional>

#include "runtime/c_interface/aspect.h"
#include "runtime/vision/frame.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

// ASPECT_OK and the frame, or what is wrong with it. Pixels are not looked at.
struct CheckedFrame {
  aspect_status status = ASPECT_OK;
  Frame frame;
};
CheckedFrame checked_frame(const aspect_frame& frame, SensorKind sensor) noexcept;

}  // namespace aspect
