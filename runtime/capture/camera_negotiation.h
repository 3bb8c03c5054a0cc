// What the camera offers, what is made of it, and what the driver then really does.
#pragma once

#include <string>
#include <vector>

#include "runtime/capture/camera_fault.h"
#include "runtime/capture/camera_formats.h"
#include "runtime/capture/camera_search.h"
#include "runtime/capture/v4l2_calls.h"

namespace aspect {

// What the camera has for such a sensor, each format at its best size. Also every format's name in
// `all`, for messages.
CameraFault list_offers(V4l2Calls& calls, const FoundCamera& camera, const CameraSettings& settings,
                        bool decoder, std::vector<FormatOffer>& offers, std::string& all);

// Sets format and rate and reads back what became of them, with a warning for all that differs
// from what is asked.
CameraFault negotiate_format(V4l2Calls& calls, const FoundCamera& camera,
                             const CameraSettings& settings, bool decoder, StreamFormat& stream,
                             double& rate_hz, std::vector<std::string>& warnings);

}  // namespace aspect
