// Measured colours as a project that aspectc compiles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "tools/calibrate/colours/surface_colours.h"

namespace aspect {

// New colours under which a picture of the scene shows the measured shares: the scene's light is
// taken out of them. As light as the surface is now, as far as no channel goes above 1.
struct NewSurface {
  int index = 0;
  Eigen::Vector3d diffuse, ambient;
};
std::vector<NewSurface> new_surfaces(const Scene& scene, const std::vector<Paint>& paints,
                                     const std::vector<PaintColour>& colours);

// The text of `output`: of a project the same with [[surface]] tables at its end, in place of those
// that an earlier run has left; of a scene a new project that names it. Fails where a project would
// not be read as the same one from there.
Result<std::string> project_with_colours(const std::filesystem::path& scene_or_project,
                                         const std::filesystem::path& output, const Scene& scene,
                                         const std::vector<Paint>& paints,
                                         const std::vector<PaintColour>& colours);

}  // namespace aspect
