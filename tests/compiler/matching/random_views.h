// Views made up for matching: contours of few colours, so that ties and near-ties happen.
#pragma once

#include <cstddef>
#include <random>

#include "compiler/matching/observed_view.h"

namespace aspect {

// `count` external contours; relations between all of them follow from their places, one in eight
// of another kind than apart.
ObservedView random_view(std::mt19937& random, std::size_t count);

// The same contours in another order, each attribute moved by noise of that size, seen from a
// direction near by, every other time with a camera rolled at random that the picture does not
// suit.
ObservedView shuffled_view(std::mt19937& random, const ObservedView& view, double noise);

// What the camera of a view sees once it is turned about its optical axis by -angle: the picture
// turns by +angle, on the screen clockwise.
ObservedView rolled_view(const ObservedView& view, double angle_rad);

// The view as seen, in the same picture, from another place to which the camera went along the
// great circle.
ObservedView carried_view(const ObservedView& view, const Eigen::Vector3d& direction);

Eigen::Vector3d random_unit_vector(std::mt19937& random);

}  // namespace aspect
