#include "runtime/recognition/alike_poses.h"

#include <cmath>

namespace aspect {
namespace {

constexpr double kSameTurn = 1e-6;

Rotation least_turn(const Rotation& rotation, const ClassIndex& index) {
  Rotation least = rotation;
  const auto try_axes = [&](Rotation turn) {
    for (const Vector3& axis : index.symmetry_axes) {
      // The turn about the axis that leaves the largest w.
      const double along = turn.x * static_cast<double>(axis[0]) +
                           turn.y * static_cast<double>(axis[1]) +
                           turn.z * static_cast<double>(axis[2]);
      const double length = std::sqrt(turn.w * turn.w + along * along);
      if (!(length > 0)) continue;
      const double c = turn.w / length, s = -along / length;
      turn = turn * Rotation{c, s * static_cast<double>(axis[0]), s * static_cast<double>(axis[1]),
                             s * static_cast<double>(axis[2])};
    }
    if (std::abs(turn.w) > std::abs(least.w) + kSameTurn) least = turn;
  };
  try_axes(rotation);
  for (const auto& [w, x, y, z] : index.symmetries)
    try_axes(rotation * Rotation{static_cast<double>(w), static_cast<double>(x),
                                 static_cast<double>(y), static_cast<double>(z)});
  return least;
}

// About the object's centre, which stays.
RigidPose turned_to(const Rotation& rotation, const RigidPose& pose, const Vector3d& centre) {
  return {rotation, pose(centre) - rotation(centre)};
}

}  // namespace

RigidPose canonical_pose(const RigidPose& pose, const ClassIndex& index) {
  return turned_to(least_turn(pose.rotation, index), pose, index.model.centre);
}

RigidPose alike_pose_nearest(const RigidPose& pose, const Rotation& reference,
                             const ClassIndex& index) {
  if (index.symmetries.empty() && index.symmetry_axes.empty()) return pose;
  const Rotation turn = least_turn(inverse(reference) * pose.rotation, index);
  return turned_to(reference * turn, pose, index.model.centre);
}

}  // namespace aspect
