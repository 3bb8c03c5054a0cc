// Objects whose symmetries are known, made by hand.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "compiler/scene/scene.h"

namespace aspect {

// Colours 0 to 7, apart from each other for the segmentation.
Eigen::Vector3d test_colour(int colour);

// A block about the origin, in small pictures. Faces in the order +x -x +y -y +z -z.
Scene block_scene(const Eigen::Vector3d& half, const std::array<int, 6>& colours);

// An upright prism about z with a base of `sides` corners; sides, then top and bottom.
Scene prism_scene(const std::vector<int>& sides, int top, int bottom);

void add_cylinder(Scene& scene, double from_z, double to_z, double radius, int side, int end);

void rotate(Scene& scene, const Eigen::Quaterniond& rotation);

// Those of the 24 rotations of a cube that keep the colours of its faces, but for the identity.
std::vector<Eigen::Quaterniond> colour_rotations(const std::array<int, 6>& colours);

}  // namespace aspect
