// Which class every patch of the viewing sphere belongs to, in a few KiB: the tree of patches
// depth first, one bit "split"; a leaf is followed by one bit "the same as the leaf before" and,
// where it is not, by the class in as many bits as the number of classes needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/viewsphere/viewsphere.h"
#include "runtime/base/result.h"

namespace aspect {

inline constexpr std::int32_t kNoClass = -1;

struct SphereMap {
  ViewSphere sphere;
  std::vector<std::int32_t> class_of;  // by patch; meaningful for leaves
};

// Patches below `level` are merged into one of that level, which is of a class where all of its
// leaves are.
std::vector<std::uint8_t> encode_sphere_map(const ViewSphere& sphere,
                                            std::span<const std::int32_t> class_of,
                                            std::size_t class_count, int level);

// The finest map of at most `most_bytes`.
std::vector<std::uint8_t> encode_sphere_map_within(const ViewSphere& sphere,
                                                   std::span<const std::int32_t> class_of,
                                                   std::size_t class_count, std::size_t most_bytes);

Result<SphereMap> decode_sphere_map(std::span<const std::uint8_t> bytes, std::size_t class_count);

}  // namespace aspect
