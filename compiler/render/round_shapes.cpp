#include "compiler/render/round_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/check.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr unsigned kMaxPacket = 16;
constexpr float kMiss = std::numeric_limits<float>::infinity();

// Plain numbers instead of vectors: the loops over a packet become vector code that way.
struct Ray {
  float ox, oy, oz, dx, dy, dz, least, most;  // origin, direction, range
};

inline float dot(float ax, float ay, float az, float bx, float by, float bz) {
  return ax * bx + ay * by + az * bz;
}

inline float lesser(float a, float b) {
  return a < b ? a : b;
}
inline float positive(float a) {
  return a > 0 ? a : 0.0f;
}

inline float within(const Ray& ray, float distance) {
  return (distance > ray.least) & (distance < ray.most) ? distance : kMiss;
}

inline float first_hit(const RoundSphere& sphere, const Ray& ray) {
  const float fx = ray.ox - sphere.center[0], fy = ray.oy - sphere.center[1],
              fz = ray.oz - sphere.center[2];
  const float dd = dot(ray.dx, ray.dy, ray.dz, ray.dx, ray.dy, ray.dz);
  const float nearest = -dot(fx, fy, fz, ray.dx, ray.dy, ray.dz) / dd;
  const float px = fx + nearest * ray.dx, py = fy + nearest * ray.dy, pz = fz + nearest * ray.dz;
  const float inside = sphere.radius_squared - dot(px, py, pz, px, py, pz);
  const float half = std::sqrt(positive(inside) / dd);
  const float hit = lesser(within(ray, nearest - half), within(ray, nearest + half));
  return inside >= 0 ? hit : kMiss;
}

inline float first_hit(const RoundRing& ring, const Ray& ray) {
  const float nx = ring.normal[0], ny = ring.normal[1], nz = ring.normal[2];
  const float fx = ray.ox - ring.center[0], fy = ray.oy - ring.center[1],
              fz = ray.oz - ring.center[2];
  const float distance = -dot(fx, fy, fz, nx, ny, nz) / dot(ray.dx, ray.dy, ray.dz, nx, ny, nz);
  const float px = fx + distance * ray.dx, py = fy + distance * ray.dy, pz = fz + distance * ray.dz;
  const float squared = dot(px, py, pz, px, py, pz);
  const bool on_ring = (squared >= ring.min_squared) & (squared <= ring.max_squared);
  return on_ring ? within(ray, distance) : kMiss;
}

// |p|^2 - s^2 = (mean radius + slope s)^2 with p from the middle, s = p . axis.
inline float first_hit(const RoundCone& cone, const Ray& ray) {
  const float wx = cone.axis[0], wy = cone.axis[1], wz = cone.axis[2];
  const float fx = ray.ox - cone.middle[0], fy = ray.oy - cone.middle[1],
              fz = ray.oz - cone.middle[2];
  const float nearest = -dot(fx, fy, fz, ray.dx, ray.dy, ray.dz) /
                        dot(ray.dx, ray.dy, ray.dz, ray.dx, ray.dy, ray.dz);
  const float px = fx + nearest * ray.dx, py = fy + nearest * ray.dy, pz = fz + nearest * ray.dz;

  const float along = dot(px, py, pz, wx, wy, wz);
  const float step = dot(ray.dx, ray.dy, ray.dz, wx, wy, wz);
  const float gx = px - along * wx, gy = py - along * wy, gz = pz - along * wz;
  const float ex = ray.dx - step * wx, ey = ray.dy - step * wy, ez = ray.dz - step * wz;
  const float radius = cone.mean_radius + cone.slope * along;
  const float growth = cone.slope * step;
  const float a = dot(ex, ey, ez, ex, ey, ez) - growth * growth;
  const float b = dot(gx, gy, gz, ex, ey, ez) - growth * radius;
  const float c = dot(gx, gy, gz, gx, gy, gz) - radius * radius;

  const float inside = b * b - a * c;
  const float q = -(b + std::copysign(std::sqrt(positive(inside)), b));
  const float t0 = q / a, t1 = c / q;
  const bool on0 = std::abs(along + t0 * step) <= cone.half_length;
  const bool on1 = std::abs(along + t1 * step) <= cone.half_length;
  const float hit0 = on0 ? within(ray, nearest + t0) : kMiss;
  const float hit1 = on1 ? within(ray, nearest + t1) : kMiss;
  return inside >= 0 ? lesser(hit0, hit1) : kMiss;
}

// `rays` holds `count` rays, one array a field, in the order of RTCRayN.
template <typename Shape>
void first_hits(const Shape& shape, RTCRayN* rays, unsigned count, float* hits) {
  const float* ox = &RTCRayN_org_x(rays, count, 0);
  const float* oy = ox + count;
  const float* oz = oy + count;
  const float* least = oz + count;
  const float* dx = least + count;
  const float* dy = dx + count;
  const float* dz = dy + count;
  const float* most = dz + 2 * count;
  const Shape copy = shape;
  for (std::size_t k = 0; k < count; ++k)
    hits[k] = first_hit(copy, Ray{ox[k], oy[k], oz[k], dx[k], dy[k], dz[k], least[k], most[k]});
}

template <typename Shape>
void intersect(const RTCIntersectFunctionNArguments* arguments) {
  const unsigned count = arguments->N;
  ASPECT_DCHECK(count <= kMaxPacket);
  const auto* shapes = static_cast<const Shape*>(arguments->geometryUserPtr);
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, count);
  RTCHitN* hit = RTCRayHitN_HitN(arguments->rayhit, count);

  float hits[kMaxPacket];
  first_hits(shapes[arguments->primID], rays, count, hits);
  for (unsigned k = 0; k < count; ++k) {
    if (arguments->valid[k] == 0 || hits[k] == kMiss) continue;
    RTCRayN_tfar(rays, count, k) = hits[k];
    RTCHitN_geomID(hit, count, k) = arguments->geomID;
    RTCHitN_primID(hit, count, k) = arguments->primID;
  }
}

template <typename Shape>
void occlude(const RTCOccludedFunctionNArguments* arguments) {
  const unsigned count = arguments->N;
  ASPECT_DCHECK(count <= kMaxPacket);
  const auto* shapes = static_cast<const Shape*>(arguments->geometryUserPtr);

  float hits[kMaxPacket];
  first_hits(shapes[arguments->primID], arguments->ray, count, hits);
  for (unsigned k = 0; k < count; ++k)
    if (arguments->valid[k] != 0 && hits[k] != kMiss)
      RTCRayN_tfar(arguments->ray, count, k) = -std::numeric_limits<float>::infinity();
}

template <typename Shape>
void bound(const RTCBoundsFunctionArguments* arguments) {
  const RoundBox& box =
      static_cast<const Shape*>(arguments->geometryUserPtr)[arguments->primID].box;
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.least[0];
  bounds.lower_y = box.least[1];
  bounds.lower_z = box.least[2];
  bounds.upper_x = box.greatest[0];
  bounds.upper_y = box.greatest[1];
  bounds.upper_z = box.greatest[2];
}

RoundBox box_around(const Vector3d& least, const Vector3d& greatest, double overlap) {
  const double rounding = 2 * overlap;
  return {(least.array() - rounding).matrix().cast<float>(),
          (greatest.array() + rounding).matrix().cast<float>()};
}

// Half the extent along the coordinate axes of a circle of radius 1 about `axis`.
Vector3d reach(const Vector3d& axis) {
  return (1 - axis.array().square()).max(0).sqrt().matrix();
}

float squared(double value) {
  return static_cast<float>(value * value);
}

}  // namespace

RoundSphere rounded(const Sphere& sphere, double overlap) {
  const Vector3d corner = Vector3d::Constant(sphere.radius);
  return {box_around(sphere.center - corner, sphere.center + corner, overlap),
          sphere.center.cast<float>(), squared(sphere.radius)};
}

RoundRing rounded(const Ring& ring, double overlap) {
  const Vector3d corner = ring.max_radius * reach(ring.normal);
  return {box_around(ring.center - corner, ring.center + corner, overlap),
          ring.center.cast<float>(), ring.normal.cast<float>(),
          squared(std::max(ring.min_radius - overlap, 0.0)), squared(ring.max_radius + overlap)};
}

RoundCone rounded(const Cone& cone, double overlap) {
  const Vector3d whole = cone.apex - cone.base;
  const double length = whole.norm();
  const Vector3d axis = whole / length;
  const Vector3d base_corner = cone.base_radius * reach(axis);
  const Vector3d apex_corner = cone.apex_radius * reach(axis);

  RoundCone result;
  result.box = box_around((cone.base - base_corner).cwiseMin(cone.apex - apex_corner),
                          (cone.base + base_corner).cwiseMax(cone.apex + apex_corner), overlap);
  result.middle = ((cone.base + cone.apex) / 2).cast<float>();
  result.axis = axis.cast<float>();
  result.half_length = static_cast<float>(length / 2 + overlap);
  result.mean_radius = static_cast<float>((cone.base_radius + cone.apex_radius) / 2);
  result.slope = static_cast<float>((cone.apex_radius - cone.base_radius) / length);
  return result;
}

template <typename Shape>
void set_shapes(RTCGeometry geometry, const Shape* shapes, unsigned count) {
  rtcSetGeometryUserPrimitiveCount(geometry, count);
  // Embree hands the pointer back as it got it; the callbacks read only.
  rtcSetGeometryUserData(geometry, const_cast<Shape*>(shapes));
  rtcSetGeometryBoundsFunction(geometry, bound<Shape>, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect<Shape>);
  rtcSetGeometryOccludedFunction(geometry, occlude<Shape>);
}

template void set_shapes(RTCGeometry, const RoundSphere*, unsigned);
template void set_shapes(RTCGeometry, const RoundRing*, unsigned);
template void set_shapes(RTCGeometry, const RoundCone*, unsigned);

}  // namespace aspect
