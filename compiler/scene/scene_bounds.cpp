#include "compiler/scene/scene_bounds.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

namespace aspect {
namespace {

// The farthest point of a circle lies where the origin's shadow on its plane points away from.
double farthest_of_circle(const Eigen::Vector3d& center, const Eigen::Vector3d& unit_normal,
                          double radius, const Eigen::Vector3d& origin) {
  const Eigen::Vector3d offset = center - origin;
  const double along = offset.dot(unit_normal);
  const double across = (offset - along * unit_normal).norm();
  return std::hypot(along, across + radius);
}

struct Farthest {
  const Eigen::Vector3d& origin;

  double operator()(const Polygon& polygon) const { return farthest_of(polygon.vertices); }
  double operator()(const Mesh& mesh) const { return farthest_of(mesh.vertices); }
  double operator()(const SmoothTriangle& triangle) const { return farthest_of(triangle.vertices); }
  double operator()(const Sphere& sphere) const {
    return (sphere.center - origin).norm() + sphere.radius;
  }
  double operator()(const Ring& ring) const {
    return farthest_of_circle(ring.center, ring.normal, ring.max_radius, origin);
  }
  // Its side is made of straight lines between the rims, so nothing is farther than they are.
  double operator()(const Cone& cone) const {
    const Eigen::Vector3d axis = (cone.apex - cone.base).normalized();
    return std::max(farthest_of_circle(cone.base, axis, cone.base_radius, origin),
                    farthest_of_circle(cone.apex, axis, cone.apex_radius, origin));
  }
  double farthest_of(std::span<const Eigen::Vector3d> vertices) const {
    double farthest = 0;
    for (const Eigen::Vector3d& vertex : vertices)
      farthest = std::max(farthest, (vertex - origin).norm());
    return farthest;
  }
};

}  // namespace

double farthest_distance(const Primitive& primitive, const Eigen::Vector3d& origin) {
  return std::visit(Farthest{origin}, primitive.shape);
}

double bounding_radius(const Scene& scene) {
  double radius = 0;
  for (const Primitive& primitive : scene.primitives) {
    radius = std::max(radius, farthest_distance(primitive, Eigen::Vector3d::Zero()));
  }
  return radius;
}

}  // namespace aspect
