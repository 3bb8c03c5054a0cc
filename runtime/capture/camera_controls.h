// Exposure, gain, white balance and all else that a driver lets one adjust, by name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/capture/camera_fault.h"
#include "runtime/capture/camera_settings.h"
#include "runtime/capture/v4l2_calls.h"

namespace aspect {

// Locks the camera's settings against other programs until the descriptor is closed, and sets the
// controls in the order given, so that what switches an automatic off can come before what it
// governed. Then reads all back: `values` gets "exposure = 100" of each, `warnings` a line for each
// that is missing, refused, or not what was asked for. Nothing is done for no controls. Fails only
// where the camera is gone.
CameraFault set_controls(V4l2Calls& calls, int descriptor, std::span<const CameraControl> controls,
                         std::vector<std::string>& values, std::vector<std::string>& warnings);

}  // namespace aspect
