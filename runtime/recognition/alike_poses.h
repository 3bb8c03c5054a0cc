// Poses of a symmetric object that no view tells apart.
#pragma once

#include "runtime/recognition/class_index.h"
#include "runtime/recognition/rigid_pose.h"

namespace aspect {

// The one of them whose turn is least.
RigidPose canonical_pose(const RigidPose& pose, const ClassIndex& index);

// The one of them that is turned least against `reference`.
RigidPose alike_pose_nearest(const RigidPose& pose, const Rotation& reference,
                             const ClassIndex& index);

}  // namespace aspect
