// What a project says of the scene itself: camera, light, surfaces.
#pragma once

#include "compiler/scene/scene.h"
#include "compiler/store/done.h"
#include "runtime/base/result.h"
#include "tools/aspectc/options/compile_settings.h"

namespace aspect {

// The scene as the settings want it. Where that changes anything, its source does too, so that a
// store and an index know; settings that say what the scene says change nothing. An error names the
// line of a surface that is not there.
Result<Done> apply_settings(const CompileSettings& settings, Scene& scene);

// The camera as [camera] would have to say it.
StudioCameraSettings studio_camera_of(const Studio& studio);

}  // namespace aspect
