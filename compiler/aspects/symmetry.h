// Symmetries of a model, found from its views: the rotations of the object that no picture of it
// betrays, because the graphs of a view and of its rotated view are equal.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "compiler/aspects/subdivision.h"

namespace aspect {

struct Symmetries {
  // Without the identity; w >= 0, by angle. Beside an axis only a half turn that swaps its ends, if
  // there is one, since all others are products of it with turns about the axis.
  std::vector<Eigen::Quaterniond> rotations;
  // Unit vectors about which any angle does. Three stand for the full freedom of a ball.
  std::vector<Eigen::Vector3d> axes;
  std::size_t views_rendered = 0;  // that it took to be certain
};

// Proper rotations about studio.at, round which the viewing sphere stands; an axis that does not
// pass through it is no symmetry of the views. Mirror images are not rotations and do not count.
// Folds up to 36. Of objects whose views are all of one region only, symmetries about the axes of
// cube_axes() are found.
//
// A rotation is accepted when about a hundred views, spread over the sphere, were rendered again
// with the camera turned by it and all but 3 % came out equal within 2 % of the outline's area: a
// mark that shows less than that, or from fewer places, is overlooked.
//
// Stops early, with fewer symmetries, where the workshop's `stop` is set or 600 views were
// rendered. The subdivision's views must have been made with this workshop. Deterministic; no store
// needed.
Symmetries find_symmetries(const Workshop& workshop, const Subdivision& subdivision);

// Views that differ by no more than the noise of the pixel grid; roll included.
bool are_equal_views(const ObservedView& a, const ObservedView& b);

}  // namespace aspect
