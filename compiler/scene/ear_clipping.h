// Planar polygons in space cut into triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace aspect {

using Triangle = std::array<std::uint32_t, 3>;  // indices of a polygon's vertices, wound as it is

// Unit normal by Newell's method, counter-clockwise seen from its tip; zero for a polygon without
// area.
Eigen::Vector3d polygon_normal(std::span<const Eigen::Vector3d> vertices);

// True where no corner turns against the others; straight corners are allowed.
bool is_convex(std::span<const Eigen::Vector3d> vertices);

// Triangles that cover a simple polygon exactly once: their corners are the polygon's vertices, and
// a vertex in the middle of a straight edge is a corner too, so that neighbours meet at it.
// Repeated vertices are allowed, and so are holes that a double edge joins to the border (and that
// touch it nowhere else). Triangles without area are left out. A polygon that cuts itself gives
// some triangles. O(n^2).
std::vector<Triangle> triangulate(std::span<const Eigen::Vector3d> vertices);

}  // namespace aspect
