// Whether an object stays inside the picture from every side.
#pragma once

#include <string_view>

#include "compiler/scene/scene.h"

namespace aspect {

// The camera's distance from what it looks at while a model is compiled.
inline constexpr double kCompileDistance = 1.0;

// How the warning of a scene that does not fit begins. It no longer holds once the camera changes.
inline constexpr std::string_view kLeavesPicture = "the object leaves the picture at distance";

// The largest sphere around studio.at that lies in the picture from kCompileDistance.
double fitting_radius(const Studio& studio);

}  // namespace aspect
