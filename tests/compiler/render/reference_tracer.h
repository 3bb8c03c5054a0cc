// The plain renderer that ours is held against: one ray, every primitive, schoolbook formulas in
// double precision, and nothing shared with compiler/render but the camera.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "compiler/render/camera.h"
#include "compiler/scene/scene.h"

namespace aspect {

struct ReferenceHit {
  int surface = 0;  // primitive index + 1
  double depth = std::numeric_limits<double>::infinity();
};

// Along the ray origin + depth * direction.
ReferenceHit reference_hit(const Scene& scene, const Eigen::Vector3d& origin,
                           const Eigen::Vector3d& direction);

// At any point of the picture; the camera's ray has length 1 along z.
ReferenceHit reference_hit(const Scene& scene, const Camera& camera, double x_px, double y_px);

}  // namespace aspect
