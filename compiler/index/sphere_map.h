// Which class every part of the viewing sphere belongs to, in a few KiB: the tree of patches depth
// first, one bit "split"; a leaf is followed by one bit "the same as the leaf before" and, where it
// is not, by one bit "divided". An undivided leaf has its class in as many bits as the number of
// classes needs; a divided one, two bits with the number of its pieces less two, then for each the
// place where it starts, in sixteenths of an edge, six bits, and its class.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/viewsphere/patch_division.h"
#include "compiler/viewsphere/viewsphere.h"
#include "runtime/base/result.h"

namespace aspect {

struct SphereMap {
  ViewSphere sphere;
  SphereClasses classes;

  std::int32_t at(const Eigen::Vector3d& direction) const { return classes.at(sphere, direction); }
};

// Patches below `level` are merged into one of that level, divided if need be. Classes from
// class_count on become kNoClass.
std::vector<std::uint8_t> encode_sphere_map(const ViewSphere& sphere, const SphereClasses& classes,
                                            std::size_t class_count, int level);

// The finest map of at most `most_bytes`.
std::vector<std::uint8_t> encode_sphere_map_within(const ViewSphere& sphere,
                                                   const SphereClasses& classes,
                                                   std::size_t class_count, std::size_t most_bytes);

Result<SphereMap> decode_sphere_map(std::span<const std::uint8_t> bytes, std::size_t class_count);

}  // namespace aspect
