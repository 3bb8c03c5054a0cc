// How far primitives reach.
#pragma once

#include <Eigen/Core>

#include "compiler/scene/scene.h"

namespace aspect {

// The distance from `origin` to the primitive's farthest point.
double farthest_distance(const Primitive& primitive, const Eigen::Vector3d& origin);

}  // namespace aspect
