// One picture file as a frame.
#pragma once

#include <filesystem>

#include "runtime/capture/frame_source.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

// Fills in size, pixels and, where that fails, the error. A file has at most 512 MiB. It must hold
// what such a sensor gives: range and surface frames are pictures of one channel of 16 bits.
[[nodiscard]] bool read_picture(const std::filesystem::path& file, SensorKind sensor,
                                CapturedFrame& frame);

}  // namespace aspect
