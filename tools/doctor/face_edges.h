// Which faces meet at which edges.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/doctor/face_set.h"

namespace aspect {

// A piece of a face's border, from its lower vertex to its higher one.
struct BorderPiece {
  std::uint32_t from = 0, to = 0;
  std::uint32_t face = 0;
  bool forward = true;  // whether the face goes round that way
};

struct FaceLink {
  std::uint32_t first = 0, second = 0;
  bool agree = true;  // both show the same side: they go along their edge in opposite directions
};

struct FaceEdges {
  std::vector<BorderPiece> open;   // of one face alone
  std::vector<BorderPiece> borne;  // likewise, but standing on another face, as a peg's on a block
  std::vector<BorderPiece> crowded;  // of more than two; one for each such edge
  std::vector<FaceLink> links;       // of exactly two
};

// Of the faces that are kept. An edge that vertices of other open edges lie on counts as its pieces
// (T-junctions). Above a limit of work on broken
// meshes these two are left out, and such edges count as open. O(n log n) for closed meshes.
FaceEdges face_edges(const FaceSet& set, const std::vector<bool>& kept);

}  // namespace aspect
