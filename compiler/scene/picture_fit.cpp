#include "compiler/scene/picture_fit.h"

#include <algorithm>
#include <cmath>

namespace aspect {

double fitting_radius(const Studio& studio) {
  const double half_width = std::tan(studio.angle_deg / 2 * 3.14159265358979323846 / 180);
  const double half_height = half_width / studio.aspect;
  if (studio.projection == Projection::kOrthogonal)
    return studio.width / 2 * std::min(1.0, 1 / studio.aspect);
  // The cone of rays that touches a sphere of radius r at distance d opens by asin(r / d).
  return kCompileDistance * std::sin(std::atan(std::min(half_width, half_height)));
}

}  // namespace aspect
