// The workbench behind the page: it looks at copies of the loop's frames, and hands the loop what
// was changed.
#pragma once

#include <memory>

#include "runtime/capture/v4l2_calls.h"
#include "runtime/service/workbench.h"
#include "runtime/workbench/play_control.h"

namespace aspect {

struct WorkbenchParts {
  V4l2Calls* calls = nullptr;   // for the camera's controls; null: the kernel's
  PlayControl* play = nullptr;  // of recorded frames; null: they come from a camera
};

// Null: this build has none. What the parts point to outlives it.
std::unique_ptr<Workbench> make_workbench(const WorkbenchParts& parts);

// For Daemon.
std::unique_ptr<Workbench> make_camera_workbench(V4l2Calls* calls);

}  // namespace aspect
