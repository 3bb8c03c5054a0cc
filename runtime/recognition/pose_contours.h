// Which contours of a frame are which of a class, where the object's pose is known.
#pragma once

#include <cstddef>
#include <span>

#include "runtime/recognition/class_index.h"
#include "runtime/recognition/hypothesis.h"
#include "runtime/vision/segment.h"

namespace aspect {

// Writes the matches, ascending by the contours' names, as far as there is room, and returns how
// many. A contour of the class is the region of its colour that lies where the pose shows its
// centre, or whose own centre is there; each region is the first one of those that it may be. What
// is covered or ran together with something else has none. O(contours of the class x contours).
std::size_t contours_at_pose(const ClassIndex& index, std::size_t class_id, const RigidPose& pose,
                             const CameraModel& camera, const RegionMap& regions,
                             std::span<const Contour> contours, std::span<ContourMatch> out);

}  // namespace aspect
