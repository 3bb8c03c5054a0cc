// A model's symmetries as the axes that people see in it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compiler/aspects/symmetry.h"

namespace aspect {

struct ObjectAxis {
  Eigen::Vector3d direction{0, 0, 1};  // unit vector; its largest coordinate is positive
  int fold = 0;                        // the same after 1/fold of a turn; 0: after any
};

// Round ones first, then by fold, highest first.
std::vector<ObjectAxis> object_axes(const Symmetries& symmetries);

}  // namespace aspect
