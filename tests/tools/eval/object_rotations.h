// The proper rotations that leave an object as it is, in shape and colour: found from the scene's
// primitives, which the compiler, looking at views only, does not do.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compiler/scene/scene.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

// Rotations about studio.at, round which the viewing sphere stands; the identity comes first. Those
// looked for are the 24 of the cube, n-fold turns about x, y and z with n = 2, 3, 5, 6, 8, 12 and
// 360 (which stands for any angle), and products of two that were found.
// Compares the lists of primitives: a face that is cut differently from its image hides a symmetry.
// Lights are left out. O(candidates * primitives^2) at worst.
std::vector<Eigen::Matrix3d> object_rotations(const Scene& scene);

}  // namespace aspect
