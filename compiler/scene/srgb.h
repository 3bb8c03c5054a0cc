// Colours in proportion to light, and as displays take them (IEC 61966-2-1).
#pragma once

#include <Eigen/Core>

namespace aspect {

// By channel; what is out of 0..1 is brought there.
Eigen::Vector3d srgb_of_linear(const Eigen::Vector3d& linear);
Eigen::Vector3d linear_of_srgb(const Eigen::Vector3d& srgb);

// Of CIE XYZ with the white D65, Y 0..1.
Eigen::Vector3d srgb_of_xyz(const Eigen::Vector3d& xyz);

}  // namespace aspect
