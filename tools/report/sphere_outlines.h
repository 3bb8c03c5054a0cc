// Half of the viewing sphere as it is seen from far away: the thesis's projections (Figures 4.8 to
// 4.20) and others.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "tools/report/sphere_mesh.h"

namespace aspect {

// Unit vectors, object coordinates: what goes right and up in the picture, and towards the eye.
struct LookFrame {
  Eigen::Vector3d right{1, 0, 0}, up{0, 1, 0}, towards{0, 0, 1};

  Eigen::Vector2d operator()(const Eigen::Vector3d& point) const {
    return {point.dot(right), point.dot(up)};
  }
};

// Closed, without repeating the first point; counter-clockwise round what it holds. In the disc of
// radius 1.
using Outline = std::vector<Eigen::Vector2d>;

// The outlines of every class, kNoClass among them, in the half of the sphere towards the eye. A
// piece that lies across its rim is cut there. O(pieces).
std::map<std::int32_t, std::vector<Outline>> class_outlines(const SphereMesh& mesh,
                                                            const LookFrame& frame);

// Sides of the pieces in that half, each once, cut at the rim: two points each.
std::vector<std::array<Eigen::Vector2d, 2>> patch_sides(const SphereMesh& mesh,
                                                        const LookFrame& frame);

// Signed area of what it goes round counter-clockwise.
double area_of(const Outline& outline);

}  // namespace aspect
