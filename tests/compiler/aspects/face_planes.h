// The exact aspects of a convex object: which faces a camera at distance 1 sees follows from the
// sides of the faces' planes that it is on. The outside oracle for clusters.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "compiler/scene/scene.h"

namespace aspect {

struct FacePlane {
  Eigen::Vector3d normal;  // outwards
  double distance = 0;
  double above(const Eigen::Vector3d& camera) const { return camera.dot(normal) - distance; }
};

// One for each polygon; the surface id of plane k is k + 1.
std::vector<FacePlane> face_planes(const Scene& scene);

// Bit k is set where the camera sees face k.
using VisibleFaces = std::uint32_t;
VisibleFaces visible_faces(const std::vector<FacePlane>& planes, const Eigen::Vector3d& camera);

double distance_to_nearest(const std::vector<FacePlane>& planes, const Eigen::Vector3d& camera);

// Share of the sphere from which each set of faces is seen, summed over `points` evenly spread
// directions.
std::map<VisibleFaces, double> exact_areas(const std::vector<FacePlane>& planes, int points);

}  // namespace aspect
