#include "compiler/render/surface_normal.h"

#include <Eigen/Geometry>

namespace aspect {
namespace {

using Eigen::Vector3d;

// Shorter sums of normals have no direction to speak of.
constexpr double kLeastLength = 1e-6;

// Its length is twice the area.
Vector3d plane_normal(const SmoothTriangle& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  return (b - a).cross(c - a);
}

}  // namespace

Vector3d normal_at(const Sphere& sphere, const Vector3d& point) {
  return (point - sphere.center).normalized();
}

Vector3d normal_at(const Ring& ring, const Vector3d&) {
  return ring.normal;
}

Vector3d normal_at(const Cone& cone, const Vector3d& point) {
  const Vector3d whole = cone.apex - cone.base;
  const Vector3d axis = whole.normalized();
  const Vector3d from_base = point - cone.base;
  const Vector3d outwards = (from_base - from_base.dot(axis) * axis).normalized();
  const double slope = (cone.apex_radius - cone.base_radius) / whole.norm();
  return (outwards - slope * axis).normalized();
}

Vector3d weights_at(const SmoothTriangle& triangle, const Vector3d& point) {
  const auto& [a, b, c] = triangle.vertices;
  const Vector3d normal = plane_normal(triangle);
  const double area = normal.squaredNorm();
  const double of_b = (point - a).cross(c - a).dot(normal) / area;
  const double of_c = (b - a).cross(point - a).dot(normal) / area;
  return {1 - of_b - of_c, of_b, of_c};
}

Vector3d normal_at(const SmoothTriangle& triangle, const Vector3d& point) {
  const Vector3d weights = weights_at(triangle, point);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    sum += weights[static_cast<Eigen::Index>(k)] * triangle.normals[k];
  return sum.norm() < kLeastLength ? plane_normal(triangle).normalized() : sum.normalized();
}

}  // namespace aspect
