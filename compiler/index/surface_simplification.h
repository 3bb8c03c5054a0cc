// Fewer triangles for a surface, with the borders between its colours kept.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace aspect {

struct ColouredTriangle {
  std::array<std::uint32_t, 3> corners{};  // into points
  std::uint16_t paint = 0;
};

// Triangles that meet share their points.
struct ColouredSurface {
  std::vector<Eigen::Vector3d> points;
  std::vector<ColouredTriangle> triangles;
};

struct SimplifiedSurface {
  ColouredSurface surface;
  double error = 0;  // largest distance to it of some thousands of the surface's points
};

// Collapses edges by meshoptimizer's quadrics (Garland and Heckbert, 1997): as far as `error`
// allows and, while more than `enough` triangles are left, as twice that does, and so on.
SimplifiedSurface simplified_surface(const ColouredSurface& surface, std::size_t enough,
                                     double error);

}  // namespace aspect
