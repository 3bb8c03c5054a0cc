// Where an object stands before the camera: a rotation and a translation. Plain loops over doubles,
// so that results have the same bits on every processor.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace aspect {

using Vector3d = std::array<double, 3>;

constexpr Vector3d operator+(const Vector3d& a, const Vector3d& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
constexpr Vector3d operator-(const Vector3d& a, const Vector3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
constexpr Vector3d operator*(double factor, const Vector3d& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
constexpr double dot(const Vector3d& a, const Vector3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
constexpr Vector3d cross(const Vector3d& a, const Vector3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vector3d& a) {
  return std::sqrt(dot(a, a));
}

// A unit quaternion w x y z.
struct Rotation {
  double w = 1, x = 0, y = 0, z = 0;

  Vector3d operator()(const Vector3d& p) const;
  std::array<Vector3d, 3> rows() const;
};

// First b, then a. Of length 1 again.
Rotation operator*(const Rotation& a, const Rotation& b);
Rotation inverse(const Rotation& a);
Rotation rotation_from_rows(const std::array<Vector3d, 3>& rows);
Rotation turn_about(const Vector3d& axis_unit, double angle_rad);

// The least turn that takes one unit vector to the other.
Rotation turn_between(const Vector3d& from_unit, const Vector3d& to_unit);

double angle_between_rad(const Rotation& a, const Rotation& b);

// Object coordinates to camera coordinates: x right, y down, z forward.
struct RigidPose {
  Rotation rotation;
  Vector3d translation{};

  Vector3d operator()(const Vector3d& p) const { return rotation(p) + translation; }
};

// The rotation of a camera without roll that looks at an object from `direction`, a unit vector
// from the object to the camera: z = -direction, x = normalised cross(z, up), y = cross(z, x).
// Where up is parallel to the direction, another axis stands in for it, always the same one.
Rotation camera_from_object(const Vector3d& direction_unit, const Vector3d& up);

}  // namespace aspect
