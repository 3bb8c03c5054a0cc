// Spheres, rings and cones as Embree geometry, hit exactly where their equations say.
//
// Single precision, but every formula starts from the ray's point nearest to the shape's middle:
// what cancels is then as small as the shape, and silhouettes are right to 0.001 pixel.
#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Core>

#include "compiler/scene/scene.h"

namespace aspect {

struct RoundBox {
  Eigen::Vector3f least, greatest;  // holds the shape, some rounding included
};

struct RoundSphere {
  RoundBox box;
  Eigen::Vector3f center;
  float radius_squared = 0;
};

struct RoundRing {
  RoundBox box;
  Eigen::Vector3f center, normal;
  float min_squared = 0, max_squared = 0;
};

struct RoundCone {
  RoundBox box;
  Eigen::Vector3f middle, axis;  // axis: unit length, towards the apex
  float half_length = 0;
  float mean_radius = 0;
  float slope = 0;  // of the radius, along the axis
};

// `overlap` is the length by which the rims of rings and cones stand out, so that no ray slips
// through where a rim meets its neighbour's.
RoundSphere rounded(const Sphere& sphere, double overlap);
RoundRing rounded(const Ring& ring, double overlap);
RoundCone rounded(const Cone& cone, double overlap);

// Makes `geometry` (of the user type) stand for `count` shapes, which must outlive it unmoved.
template <typename Shape>
void set_shapes(RTCGeometry geometry, const Shape* shapes, unsigned count);

}  // namespace aspect
