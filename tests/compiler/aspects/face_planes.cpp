#include "tests/compiler/aspects/face_planes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace aspect {

std::vector<FacePlane> face_planes(const Scene& scene) {
  std::vector<FacePlane> planes;
  for (const Primitive& primitive : scene.primitives) {
    const std::vector<Eigen::Vector3d>& v = std::get<Polygon>(primitive.shape).vertices;
    Eigen::Vector3d normal = (v[1] - v[0]).cross(v[2] - v[0]).normalized();
    if (normal.dot(v[0]) < 0) normal = -normal;
    planes.push_back({normal, normal.dot(v[0])});
  }
  return planes;
}

VisibleFaces visible_faces(const std::vector<FacePlane>& planes, const Eigen::Vector3d& camera) {
  VisibleFaces faces = 0;
  for (std::size_t k = 0; k < planes.size(); ++k)
    if (planes[k].above(camera) > 0) faces |= 1U << k;
  return faces;
}

double distance_to_nearest(const std::vector<FacePlane>& planes, const Eigen::Vector3d& camera) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const FacePlane& plane : planes) nearest = std::min(nearest, std::abs(plane.above(camera)));
  return nearest;
}

// Fibonacci's spiral: every point stands for the same area.
std::map<VisibleFaces, double> exact_areas(const std::vector<FacePlane>& planes, int points) {
  std::map<VisibleFaces, double> areas;
  for (int i = 0; i < points; ++i) {
    const double z = 1 - (2 * i + 1.0) / points;
    const double longitude = 2 * std::numbers::pi * i / std::numbers::phi;
    const double ring = std::sqrt(1 - z * z);
    const Eigen::Vector3d camera(ring * std::cos(longitude), ring * std::sin(longitude), z);
    areas[visible_faces(planes, camera)] += 1.0 / points;
  }
  return areas;
}

}  // namespace aspect
