#include "tests/compiler/render/reference_tracer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kMiss = std::numeric_limits<double>::infinity();

struct FirstHit {
  Vector3d origin, direction;

  double operator()(const Polygon& polygon) const {
    Vector3d normal = Vector3d::Zero();
    for (std::size_t k = 0; k < polygon.vertices.size(); ++k)
      normal += polygon.vertices[k].cross(polygon.vertices[(k + 1) % polygon.vertices.size()]);
    const double depth = (polygon.vertices[0] - origin).dot(normal) / direction.dot(normal);
    if (!(depth > 0)) return kMiss;

    Eigen::Index dropped = 0;
    normal.cwiseAbs().maxCoeff(&dropped);
    const Eigen::Index u = (dropped + 1) % 3, v = (dropped + 2) % 3;
    const Vector3d p = origin + depth * direction;
    bool inside = false;
    for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
      const Vector3d& a = polygon.vertices[k];
      const Vector3d& b = polygon.vertices[(k + 1) % polygon.vertices.size()];
      if ((a[v] > p[v]) != (b[v] > p[v]) &&
          p[u] < a[u] + (b[u] - a[u]) * (p[v] - a[v]) / (b[v] - a[v]))
        inside = !inside;
    }
    return inside ? depth : kMiss;
  }

  double operator()(const SmoothTriangle& triangle) const {
    const auto& [a, b, c] = triangle.vertices;
    return (*this)(Polygon{{a, b, c}});
  }

  double operator()(const Sphere& sphere) const {
    const Vector3d from_center = origin - sphere.center;
    return least_root(direction.squaredNorm(), 2 * direction.dot(from_center),
                      from_center.squaredNorm() - sphere.radius * sphere.radius,
                      [](double) { return true; });
  }

  double operator()(const Ring& ring) const {
    const double depth = (ring.center - origin).dot(ring.normal) / direction.dot(ring.normal);
    const double radius = (origin + depth * direction - ring.center).norm();
    return depth > 0 && radius >= ring.min_radius && radius <= ring.max_radius ? depth : kMiss;
  }

  double operator()(const Cone& cone) const {
    const double length = (cone.apex - cone.base).norm();
    const Vector3d axis = (cone.apex - cone.base) / length;
    const double slope = (cone.apex_radius - cone.base_radius) / length;
    const Vector3d from_base = origin - cone.base;
    const double height = from_base.dot(axis), rise = direction.dot(axis);
    const Vector3d p = from_base - height * axis, d = direction - rise * axis;
    const double radius = cone.base_radius + slope * height, growth = slope * rise;
    return least_root(d.squaredNorm() - growth * growth, 2 * (p.dot(d) - radius * growth),
                      p.squaredNorm() - radius * radius, [&](double depth) {
                        const double at = height + depth * rise;
                        return at >= 0 && at <= length;
                      });
  }

  double operator()(const Mesh& mesh) const {
    double least = kMiss;
    for (const auto& [a, b, c] : mesh.triangles)
      least = std::min(
          least, operator()(Polygon{{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}}));
    return least;
  }

  template <typename Allowed>
  static double least_root(double a, double b, double c, Allowed allowed) {
    const double inside = b * b - 4 * a * c;
    if (inside < 0) return kMiss;
    double least = kMiss;
    for (const double sign : {-1.0, 1.0}) {
      const double root = (-b + sign * std::sqrt(inside)) / (2 * a);
      if (root > 0 && allowed(root)) least = std::min(least, root);
    }
    return least;
  }
};

}  // namespace

ReferenceHit reference_hit(const Scene& scene, const Vector3d& origin, const Vector3d& direction) {
  ReferenceHit nearest;
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const double depth = std::visit(FirstHit{origin, direction}, scene.primitives[k].shape);
    if (depth < nearest.depth) nearest = {static_cast<int>(k) + 1, depth};
  }
  return nearest;
}

ReferenceHit reference_hit(const Scene& scene, const Camera& camera, double x_px, double y_px) {
  const Intrinsics& in = camera.intrinsics;
  const Eigen::Matrix3d object_from_camera = camera.camera_from_object.transpose();
  Vector3d across((x_px - in.cx_px) / in.fx_px, (y_px - in.cy_px) / in.fy_px, 0);
  if (in.projection == Projection::kOrthogonal)
    return reference_hit(scene, camera.position_object + object_from_camera * across,
                         object_from_camera.col(2));
  across.z() = 1;
  return reference_hit(scene, camera.position_object, object_from_camera * across);
}

}  // namespace aspect
