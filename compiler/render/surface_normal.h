// Unit normals of shapes at a point on or near them; on either side.
#pragma once

#include <Eigen/Core>

#include "compiler/scene/scene.h"

namespace aspect {

Eigen::Vector3d normal_at(const Sphere& sphere, const Eigen::Vector3d& point);
Eigen::Vector3d normal_at(const Ring& ring, const Eigen::Vector3d& point);
Eigen::Vector3d normal_at(const Cone& cone, const Eigen::Vector3d& point);
// Between those of the vertices; its plane's where they cancel out.
Eigen::Vector3d normal_at(const SmoothTriangle& triangle, const Eigen::Vector3d& point);

// The weights of the vertices at a point of the triangle's plane; they add up to 1.
Eigen::Vector3d weights_at(const SmoothTriangle& triangle, const Eigen::Vector3d& point);

}  // namespace aspect
