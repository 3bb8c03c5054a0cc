// Spheres and directions that the tests of the viewing sphere share; the same for the same seed.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

#include "compiler/viewsphere/viewsphere.h"

namespace aspect {

// Every leaf at this level.
ViewSphere uniform_sphere(int level);

// Splits leaves drawn at random, none beyond `max_level`. Every third split goes into the finest
// leaf around a fixed spot, so that leaves of far apart levels meet.
ViewSphere random_sphere(std::uint32_t seed, int splits, int max_level);

Eigen::Vector3d random_direction(std::mt19937& random);

}  // namespace aspect
