#include "runtime/recognition/rigid_pose.h"

#include <algorithm>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

Rotation normalised(const Rotation& q) {
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

// Depends on `up` only, so that all views of an object share it.
Vector3d stand_in_for(const Vector3d& up) {
  std::size_t least = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (std::abs(up[axis]) < std::abs(up[least])) least = axis;
  Vector3d unit{};
  unit[least] = 1;
  return unit;
}

}  // namespace

std::array<Vector3d, 3> Rotation::rows() const {
  return {Vector3d{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
          Vector3d{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
          Vector3d{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
}

Vector3d Rotation::operator()(const Vector3d& p) const {
  const Vector3d axis{x, y, z};
  const Vector3d t = 2 * cross(axis, p);
  return p + w * t + cross(axis, t);
}

Rotation operator*(const Rotation& a, const Rotation& b) {
  return normalised({a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                     a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                     a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                     a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w});
}

Rotation inverse(const Rotation& a) {
  return {a.w, -a.x, -a.y, -a.z};
}

Rotation rotation_from_rows(const std::array<Vector3d, 3>& m) {
  // Of four ways to the same quaternion, the one that divides by the largest number.
  const double trace = m[0][0] + m[1][1] + m[2][2];
  if (trace > 0)
    return normalised({1 + trace, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]});
  if (m[0][0] >= m[1][1] && m[0][0] >= m[2][2])
    return normalised(
        {m[2][1] - m[1][2], 1 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[0][2] + m[2][0]});
  if (m[1][1] >= m[2][2])
    return normalised(
        {m[0][2] - m[2][0], m[0][1] + m[1][0], 1 + m[1][1] - m[0][0] - m[2][2], m[1][2] + m[2][1]});
  return normalised(
      {m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1 + m[2][2] - m[0][0] - m[1][1]});
}

Rotation turn_about(const Vector3d& axis_unit, double angle_rad) {
  const double s = portable_sin(angle_rad / 2);
  return {portable_cos(angle_rad / 2), s * axis_unit[0], s * axis_unit[1], s * axis_unit[2]};
}

Rotation turn_between(const Vector3d& from_unit, const Vector3d& to_unit) {
  constexpr double kOpposite = 1e-9;
  const double w = 1 + dot(from_unit, to_unit);
  if (w < kOpposite) {
    const Vector3d axis = cross(from_unit, stand_in_for(from_unit));
    return turn_about((1 / norm(axis)) * axis, 3.14159265358979323846);
  }
  const Vector3d axis = cross(from_unit, to_unit);
  return normalised({w, axis[0], axis[1], axis[2]});
}

double angle_between_rad(const Rotation& a, const Rotation& b) {
  const double w = std::abs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z);
  return 2 * portable_acos(std::min(1.0, w));
}

Rotation camera_from_object(const Vector3d& direction_unit, const Vector3d& up) {
  // Below this sine the rounding of `up` would choose the camera's roll.
  constexpr double kParallel = 1e-9;
  const Vector3d z = -1 * direction_unit;
  Vector3d x = cross(z, up);
  if (norm(x) <= kParallel * norm(up)) x = cross(z, stand_in_for(up));
  x = (1 / norm(x)) * x;
  return rotation_from_rows({x, cross(z, x), z});
}

}  // namespace aspect
