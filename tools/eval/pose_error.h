// How far a pose found is from the true one, for an observer who cannot tell the object's
// symmetries apart.
#pragma once

#include "compiler/render/camera.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/rigid_pose.h"

namespace aspect {

struct PoseError {
  double rotation_deg = 0;
  double translation_percent = 0;  // how far the object's centre is off, of its distance
  double reprojection_px = 0;      // root mean square, how far the model's vertices are off
};

// Where an object stands before a camera that is placed in the scene's coordinates, in those and in
// the units of the scene's file, which are the index's.
RigidPose true_pose(const Camera& camera, const SourceFromObject& source = {});

// Of the poses that look like `pose`, the one that is turned least against `found`: turns about a
// round axis are taken by any angle, and those of a ball leave no turn at all.
RigidPose nearest_alike(const ClassIndex& index, const RigidPose& pose, const RigidPose& found);

// In a picture in perspective. A vertex is off by the picture's diagonal at most, and by that where
// it is not before the camera.
PoseError pose_error(const ClassIndex& index, const Intrinsics& intrinsics, const RigidPose& truth,
                     const RigidPose& found);

}  // namespace aspect
