// The lines of an object at a pose as a camera shows them, for drawing.
#pragma once

#include <vector>

#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/object_model.h"

namespace aspect {

using PictureLine = std::vector<Point2d>;  // in the frame, bent by the lens

// From one point in camera coordinates to another. In pieces where a part of it is behind the
// camera or so far beside the frame that the lens model says nothing of it.
std::vector<PictureLine> line_through(const Vector3d& from, const Vector3d& to,
                                      const CameraModel& camera, int width_px, int height_px);

// Whether a surface goes on across an edge: both sides have one colour and turn by less than 35
// degrees, as the facets of a round one do. Such an edge is a line only where it is an outline.
bool is_smooth(const ObjectModel& model, const ModelEdge& edge);

// The model's edges as far as no surface hides them, and none between facets of a round surface.
// O(edges + pixels that the object covers).
std::vector<PictureLine> edges_seen(const ObjectModel& model, const RigidPose& pose,
                                    const CameraModel& camera, int width_px, int height_px);

}  // namespace aspect
