// Parts that never become a contour.
#pragma once

#include <functional>

#include "tools/doctor/finding.h"
#include "tools/doctor/sight.h"

namespace aspect {

// Parts too small or too thin for the segmentation from wherever they are looked at, and parts that
// are never seen. Dark parts are not among them, nor, but for hidden ones, those that `is_known`
// passes over since it has been told what ails them. `distance` is that of the sight.
std::vector<Finding> check_visibility(const Sight& sight, const VisionParameters& vision,
                                      double distance,
                                      const std::function<bool(std::size_t part)>& is_known = {});

}  // namespace aspect
