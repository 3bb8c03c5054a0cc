// NAME.toml: a compile project. It names the scene and says what is to be done otherwise.
//   scene = "part.b"      # relative to the project
//   [segmentation]        # the keys of VisionParameters; the index keeps them for the runtime
#pragma once

#include <filesystem>

#include "runtime/base/result.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

struct Project {
  std::filesystem::path scene;
  VisionParameters vision;
};

// Errors name file and line: unknown keys with the nearest known one, wrong types, no scene. A
// region of interest is that of a frame and is left out.
// What the project leaves open is as in `vision`.
Result<Project> read_project(const std::filesystem::path& file, const VisionParameters& vision);

}  // namespace aspect
