// AutoCAD's colour numbers.
#pragma once

#include <Eigen/Core>

namespace aspect {

// The colour of number 1..255, black for all others. 1..9 are named colours; 10..249 run through
// 24 hues of 15 degrees, each at values of 100, 65, 50, 30 and 15 %, with full and with half
// saturation; 250..255 are greys.
Eigen::Vector3d aci_colour(int number);

}  // namespace aspect
