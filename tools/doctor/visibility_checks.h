// Parts that never become a contour.
#pragma once

#include "tools/doctor/finding.h"
#include "tools/doctor/sight.h"

namespace aspect {

// Parts too small or too thin for the segmentation from wherever they are looked at, and parts that
// are never seen. Dark parts are not among them. `distance` is that of the sight.
std::vector<Finding> check_visibility(const Sight& sight, const VisionParameters& vision,
                                      double distance);

}  // namespace aspect
