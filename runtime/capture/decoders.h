// What a build can read besides raw frames: pictures and videos of many kinds on a workstation,
// pictures of one kind on a device. CMake chooses the sources of a build.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/capture/frame_source.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

// Before anything else: decoders that talk are silenced.
void silence_decoders();

// One picture file as a frame. Fills in size, pixels and, where that fails, the error. A file has
// at most 512 MiB. It must hold what such a sensor gives: range and surface frames are pictures of
// one channel of 16 bits.
[[nodiscard]] bool read_picture(const std::filesystem::path& file, SensorKind sensor,
                                CapturedFrame& frame);

// The frames of a video file, one after the other; a file that is none is one failed frame.
[[nodiscard]] std::unique_ptr<FrameSource> open_video(const std::filesystem::path& file);

}  // namespace aspect
