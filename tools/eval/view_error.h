// How far a view found is from the true one, for an observer who cannot tell the object's
// symmetries apart.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "runtime/recognition/class_index.h"

namespace aspect {

// The rotations of the index's object, the identity first; turns about a round axis by every
// degree.
std::vector<Eigen::Matrix3d> index_rotations(const ClassIndex& index);

// Angle between two unit vectors; at most `pi`.
double angle_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// Angle between two views of an object, modulo its rotations.
double view_error_rad(const std::vector<Eigen::Matrix3d>& rotations, const Eigen::Vector3d& truth,
                      const Eigen::Vector3d& found);

}  // namespace aspect
