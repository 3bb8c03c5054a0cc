// One picture file as a frame.
#pragma once

#include <filesystem>

#include "runtime/capture/frame_source.h"

namespace aspect {

// Fills in size, pixels and, where that fails, the error. A file has at most 512 MiB.
[[nodiscard]] bool read_picture(const std::filesystem::path& file, CapturedFrame& frame);

}  // namespace aspect
