// Which primitives of a scene become contours.
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "compiler/aspects/observer.h"

namespace aspect {

// For each primitive, from 1, in the picture: the pixels of the largest contour of its colour that
// most of it is part of, where that is more than `largest` has already; 0 is entered for those
// that have none. Colours are
// compared where the sensor sees colours; the others code other things in a contour's shares.
void note_contours(const ObservedView& view, const Picture& picture, SensorKind sensor,
                   std::map<int, double>& largest);

// 42 directions, evenly over the sphere: the corners of a viewing sphere split once.
std::vector<Eigen::Vector3d> examined_directions();

}  // namespace aspect
