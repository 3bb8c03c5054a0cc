// The box that a scene's surfaces fill, and their diameter.
#pragma once

#include <Eigen/Core>

#include "compiler/scene/scene.h"

namespace aspect {

struct SceneExtent {
  Eigen::Vector3d least{0, 0, 0};  // corners of the box along the axes; exact for round shapes too
  Eigen::Vector3d most{0, 0, 0};
  double diameter = 0;  // largest distance between two points of the surfaces
};

// The diameter is exact but for two rims against each other: there to 1e-9 of its length. All of
// an empty scene is 0. O(primitives^2) at worst.
SceneExtent scene_extent(const Scene& scene);

}  // namespace aspect
