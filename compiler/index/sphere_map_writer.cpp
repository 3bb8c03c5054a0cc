#include "compiler/index/sphere_map_writer.h"

#include <algorithm>
#include <cmath>

#include "runtime/recognition/sphere_map.h"

namespace aspect {
namespace {

using Format = SphereMapFormat;
static_assert(SphereMap::kNone == kNoClass);

class BitWriter {
 public:
  void put(std::uint32_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit) {
      if (used_ % 8 == 0) bytes.push_back(0);
      bytes.back() =
          static_cast<std::uint8_t>(bytes.back() | ((value >> bit) & 1U) << (7 - used_ % 8));
      ++used_;
    }
  }
  std::vector<std::uint8_t> bytes;

 private:
  std::size_t used_ = 0;
};

PatchId root(std::size_t k) {
  return static_cast<PatchId>(k);
}
// Classes are sampled in the middle of these steps round a patch, this far inside it.
constexpr int kSteps = Format::kSteps, kRound = 3 * kSteps;
constexpr double kInside = 0.01;
constexpr std::int32_t kMixed = -2;

Eigen::Vector3d direction_at(const ViewSphere& sphere, const Patch& patch, double place) {
  const auto edge = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(edge);
  Eigen::Vector3d weights(kInside, kInside, kInside);
  weights[static_cast<Eigen::Index>(edge)] += 1 - share;
  weights[static_cast<Eigen::Index>((edge + 1) % 3)] += share;
  Eigen::Vector3d direction(0, 0, 0);
  for (std::size_t k = 0; k < 3; ++k)
    direction += weights[static_cast<Eigen::Index>(k)] * sphere.position(patch.corners[k]);
  return direction;
}

// Gives the pieces with the shortest stretch of edge to those before them.
void drop_shortest(PatchDivision& division) {
  while (division.places.size() > Format::kMostPieces) {
    std::size_t shortest = 0;
    double least = 3;
    for (std::size_t k = 0; k < division.places.size(); ++k) {
      const bool last = k + 1 == division.places.size();
      const double length =
          (last ? division.places[0] + 3 : division.places[k + 1]) - division.places[k];
      if (length >= least) continue;
      least = length;
      shortest = k;
    }
    division.places.erase(division.places.begin() + static_cast<std::ptrdiff_t>(shortest));
    division.classes.erase(division.classes.begin() + static_cast<std::ptrdiff_t>(shortest));
    division = joined(division);
  }
}

struct Encoder {
  const ViewSphere& sphere;
  const SphereClasses& classes;
  std::size_t class_count;
  int level;
  int bits = Format::class_bits(class_count);
  BitWriter out{};
  std::int32_t last = kNoClass;

  std::int32_t kept(std::int32_t class_id) const {
    return class_id >= static_cast<std::int32_t>(class_count) ? kNoClass : class_id;
  }

  // kMixed where there is none.
  std::int32_t common_class(PatchId id) const {
    const Patch& patch = sphere.patch(id);
    if (!patch.split)
      return classes.divisions.count(static_cast<std::uint32_t>(id)) > 0
                 ? kMixed
                 : kept(classes.class_of[number(id)]);
    const std::int32_t first = common_class(patch.children[0]);
    for (const PatchId child : patch.children)
      if (common_class(child) != first) return kMixed;
    return first;
  }

  PatchDivision sampled(const Patch& patch) const {
    PatchDivision along_edges;
    for (int step = 0; step < kRound; ++step) {
      const Eigen::Vector3d direction = direction_at(sphere, patch, (step + 0.5) / kSteps);
      along_edges.places.push_back(static_cast<double>(step) / kSteps);
      along_edges.classes.push_back(kept(classes.at(sphere, direction)));
    }
    PatchDivision division = joined(along_edges);
    drop_shortest(division);
    return division;
  }

  void put_class(std::int32_t class_id) { out.put(static_cast<std::uint32_t>(class_id + 1), bits); }

  void put_division(const PatchDivision& division) {
    out.put(0, 1);
    out.put(1, 1);
    out.put(static_cast<std::uint32_t>(division.places.size() - Format::kFewestPieces),
            Format::kPieceBits);
    for (std::size_t k = 0; k < division.places.size(); ++k) {
      out.put(static_cast<std::uint32_t>(std::lround(division.places[k] * kSteps)),
              Format::kPlaceBits);
      put_class(division.classes[k]);
    }
  }

  void put(PatchId id) {
    const Patch& patch = sphere.patch(id);
    const bool split = patch.split && patch.level < level;
    out.put(split ? 1 : 0, 1);
    if (split) {
      for (const PatchId child : patch.children) put(child);
      return;
    }
    std::int32_t own = common_class(id);
    if (own == kMixed) {
      const PatchDivision division = sampled(patch);
      if (division.places.size() >= Format::kFewestPieces) return put_division(division);
      own = division.classes[0];
    }
    out.put(own == last ? 1 : 0, 1);
    if (own == last) return;
    out.put(0, 1);
    put_class(own);
    last = own;
  }
};

}  // namespace

std::vector<std::uint8_t> encode_sphere_map(const ViewSphere& sphere, const SphereClasses& classes,
                                            std::size_t class_count, int level) {
  Encoder encoder{sphere, classes, class_count, level};
  for (std::size_t k = 0; k < Format::kRoots; ++k) encoder.put(root(k));
  return std::move(encoder.out.bytes);
}

std::vector<std::uint8_t> encode_sphere_map_within(const ViewSphere& sphere,
                                                   const SphereClasses& classes,
                                                   std::size_t class_count,
                                                   std::size_t most_bytes) {
  int deepest = 0;
  for (std::size_t i = 0; i < sphere.patch_count(); ++i)
    deepest = std::max(deepest, sphere.patch(static_cast<PatchId>(i)).level);
  for (int level = deepest; level > 0; --level) {
    std::vector<std::uint8_t> bytes = encode_sphere_map(sphere, classes, class_count, level);
    if (bytes.size() <= most_bytes) return bytes;
  }
  return encode_sphere_map(sphere, classes, class_count, 0);
}

}  // namespace aspect
