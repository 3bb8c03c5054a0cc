// The map of the viewing sphere that an index carries: runtime/recognition/sphere_map.h says how.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/viewsphere/patch_division.h"
#include "compiler/viewsphere/viewsphere.h"

namespace aspect {

// Patches below `level` are merged into one of that level, divided if need be. Classes from
// class_count on become kNoClass.
std::vector<std::uint8_t> encode_sphere_map(const ViewSphere& sphere, const SphereClasses& classes,
                                            std::size_t class_count, int level);

// The finest map of at most `most_bytes`.
std::vector<std::uint8_t> encode_sphere_map_within(const ViewSphere& sphere,
                                                   const SphereClasses& classes,
                                                   std::size_t class_count, std::size_t most_bytes);

}  // namespace aspect
