// What aspectd says to people, on standard error.
#pragma once

#include <string>
#include <string_view>

#include "runtime/capture/camera.h"

namespace aspect {

// One line, written at once; control characters in it become question marks.
void log_line(std::string_view text);

// "/dev/video0: Vivid (platform:vivid-000), YUYV 640 x 480 at 30 Hz".
std::string describe(const CameraPlan& plan);

}  // namespace aspect
