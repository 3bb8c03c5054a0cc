// Random viewpoints, uniform on the unit sphere.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace aspect {

// Marsaglia's method, thesis 4.4. The same seed gives the same directions everywhere; more of them
// begin with the same ones.
std::vector<Eigen::Vector3d> random_directions(std::size_t count, std::uint64_t seed);

}  // namespace aspect
