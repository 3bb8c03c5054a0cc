// Which faces show the wrong side.
#pragma once

#include "tools/doctor/face_edges.h"

namespace aspect {

struct FaceWinding {
  std::vector<bool> flipped;      // by face: to be turned, so that all show the outer side
  std::size_t flipped_count = 0;  // against their neighbours
  std::size_t inside_out = 0;     // closed pieces that show their inner side all over
  std::size_t one_sided = 0;      // pieces that have no two sides, as a Moebius strip
  std::vector<std::size_t> inside_out_faces;  // one of each such piece
  std::vector<std::uint32_t> inverted;        // all faces of closed pieces that are inside out
  std::vector<std::uint32_t> without_sides;   // all faces of pieces of one side only
};

// Faces joined by edges are a piece. In a closed one the faces that show the inner side are
// flipped, by the sign of its volume; in an open one those in the minority. A closed piece wound
// inwards within another closed piece is the wall of a hollow, and right.
FaceWinding face_winding(const FaceSet& set, const std::vector<bool>& kept, const FaceEdges& edges);

}  // namespace aspect
