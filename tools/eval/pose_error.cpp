#include "tools/eval/pose_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aspect {
namespace {

// Floats in the index, so their lengths are 1 but for rounding.
Vector3d unit(const Vector3& v) {
  const Vector3d wide{static_cast<double>(v[0]), static_cast<double>(v[1]),
                      static_cast<double>(v[2])};
  return (1 / norm(wide)) * wide;
}

// A product is of length 1 again.
Rotation rotation_of(const std::array<float, 4>& q) {
  return Rotation{} * Rotation{static_cast<double>(q[0]), static_cast<double>(q[1]),
                               static_cast<double>(q[2]), static_cast<double>(q[3])};
}

// The turn about the axis that is nearest to the rotation: of its quaternion, the part that the
// axis has a share in.
Rotation nearest_turn(const Rotation& rotation, const Vector3d& axis) {
  const double along = dot({rotation.x, rotation.y, rotation.z}, axis);
  return turn_about(axis, 2 * std::atan2(along, rotation.w));
}

// Of the object's symmetries.
Rotation nearest_symmetry(const ClassIndex& index, const Rotation& wanted) {
  if (index.symmetry_axes.size() > 1) return wanted;
  const auto nearest_with = [&](const Rotation& symmetry) {
    if (index.symmetry_axes.empty()) return symmetry;
    return nearest_turn(wanted * inverse(symmetry), unit(index.symmetry_axes.front())) * symmetry;
  };
  Rotation nearest = nearest_with({});
  double least = angle_between_rad(nearest, wanted);
  for (const std::array<float, 4>& q : index.symmetries) {
    const Rotation other = nearest_with(rotation_of(q));
    const double angle = angle_between_rad(other, wanted);
    if (angle >= least) continue;
    least = angle;
    nearest = other;
  }
  return nearest;
}

double squared_distance_px(const Intrinsics& camera, const Vector3d& a, const Vector3d& b) {
  const double most = static_cast<double>(camera.width_px) * camera.width_px +
                      static_cast<double>(camera.height_px) * camera.height_px;
  if (!(a[2] > 0 && b[2] > 0)) return most;
  const double x = camera.fx_px * (a[0] / a[2] - b[0] / b[2]),
               y = camera.fy_px * (a[1] / a[2] - b[1] / b[2]);
  return std::min(most, x * x + y * y);
}

}  // namespace

RigidPose true_pose(const Camera& camera, const SourceFromObject& source) {
  const Eigen::Matrix3d& m = camera.camera_from_object;
  const Eigen::Vector3d t = -m * source(camera.position_object);
  return {
      rotation_from_rows({Vector3d{m(0, 0), m(0, 1), m(0, 2)}, Vector3d{m(1, 0), m(1, 1), m(1, 2)},
                          Vector3d{m(2, 0), m(2, 1), m(2, 2)}}),
      {t.x(), t.y(), t.z()}};
}

RigidPose nearest_alike(const ClassIndex& index, const RigidPose& pose, const RigidPose& found) {
  const Vector3d& centre = index.model.centre;
  const Rotation symmetry = nearest_symmetry(index, inverse(pose.rotation) * found.rotation);
  return {pose.rotation * symmetry, pose(centre) - (pose.rotation * symmetry)(centre)};
}

PoseError pose_error(const ClassIndex& index, const Intrinsics& intrinsics, const RigidPose& truth,
                     const RigidPose& found) {
  const RigidPose alike = nearest_alike(index, truth, found);
  const Vector3d& centre = index.model.centre;
  PoseError error;
  error.rotation_deg = angle_between_rad(alike.rotation, found.rotation) * 180 / std::numbers::pi;
  error.translation_percent = 100 * norm(found(centre) - alike(centre)) / norm(alike(centre));
  double sum = 0;
  for (const Vector3d& vertex : index.model.vertices)
    sum += squared_distance_px(intrinsics, alike(vertex), found(vertex));
  const auto count = static_cast<double>(std::max<std::size_t>(1, index.model.vertices.size()));
  error.reprojection_px = std::sqrt(sum / count);
  return error;
}

}  // namespace aspect
