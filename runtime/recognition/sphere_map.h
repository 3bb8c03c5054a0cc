// Which class every part of the viewing sphere belongs to, in a few KiB: the 20 patches of an
// icosahedron with the vertices (0, +-1, +-phi) and its cyclic permutations, normalised, each split
// into four where need be (thesis 3.3.1).
//
// As an index holds it: the tree of patches depth first, one bit "split"; a leaf is followed by one
// bit "the same as the leaf before" and, where it is not, by one bit "divided". An undivided leaf
// has its class in as many bits as the number of classes needs; a divided one, two bits with the
// number of its pieces less two, then for each the place where it starts, in sixteenths of an edge,
// six bits, and its class. Class numbers are written plus one, so that 0 stands for none.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/recognition/rigid_pose.h"

namespace aspect {

// Of the format.
struct SphereMapFormat {
  static constexpr std::size_t kRoots = 20;
  static constexpr int kDeepestLevel = 12;
  static constexpr int kSteps = 16, kPlaceBits = 6;  // places along an edge
  static constexpr std::size_t kFewestPieces = 2, kMostPieces = 5;
  static constexpr int kPieceBits = 2;
  static int class_bits(std::size_t class_count) {
    return static_cast<int>(std::bit_width(class_count));
  }
};

class SphereMap {
 public:
  static constexpr std::int32_t kNone = -1;

  // A patch that is cut where borders cross its edges: piece k touches the edges from places[k] to
  // the next place and reaches to the middle of all places. Places count sixteenths of an edge,
  // from corner 0 along the edges (0,1), (1,2), (2,0), and rise.
  struct Division {
    std::uint8_t count = 0;
    std::array<std::uint8_t, SphereMapFormat::kMostPieces> places{};
    std::array<std::int32_t, SphereMapFormat::kMostPieces> classes{};
  };

  // Of unit length, counter-clockwise seen from outside.
  using Corners = std::array<Vector3d, 3>;

  struct Leaf {
    Corners corners{};
    std::int32_t class_id = kNone;       // of the whole leaf, where it is
    const Division* division = nullptr;  // not divided; lives as long as the map
  };

  // Of no class anywhere.
  SphereMap() = default;

  // The class numbers are below class_count, or the bytes are refused. O(bytes).
  static Result<SphereMap> decode(std::span<const std::uint8_t> bytes, std::size_t class_count);

  // The class that is seen from this direction, of any length but zero, or kNone; on a border one
  // of those that touch it. O(level).
  std::int32_t class_at(const Vector3d& direction) const noexcept;

  // The class with the view nearest to this unit vector (thesis 4.4.1), or kNone where there is no
  // class: its views are the corners of its undivided patches. Where that view belongs to several,
  // the one of them whose patch has the nearest centre. A few patches a level are visited.
  std::int32_t nearest_class(const Vector3d& direction_unit) const noexcept;

  // Depth first, children in order: for drawings and reports, since it allocates.
  std::vector<Leaf> leaves() const;

 private:
  // 4 bytes, since a large index has tens of thousands of them.
  struct Patch {
    enum Kind : std::uint32_t { kWhole, kDivided, kSplit, kBlind };  // split, and no class in it
    std::uint32_t kind : 2 = kWhole;
    // Its class plus one; its division; the first of its four children.
    std::uint32_t number : 30 = 0;
  };
  class BitReader;
  struct Decoder;
  struct Search;

  void append_leaves(std::uint32_t patch, const Corners& corners, std::vector<Leaf>& found) const;

  std::array<Vector3d, 12> vertices_{};
  std::vector<Patch> patches_;  // the roots first
  std::vector<Division> divisions_;
};

}  // namespace aspect
