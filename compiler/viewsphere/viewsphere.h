// The viewing sphere: an icosahedron whose triangular patches are split where the views demand it
// (thesis 3.3.1, equation 3.1), with adjacency across mixed levels (equation 3.2).
//
// Where we deviate: the thesis keeps every leaf's neighbour list up to date by surgery on the lists
// at each split. We keep one link an edge instead: to the patch of the same level that shares the
// whole edge, once it exists. Every edge piece is a whole edge at exactly one level, so the leaves
// along an edge are either below that link (same size or finer) or it is missing and the nearest
// ancestor's link is the one coarser leaf: the same lists as the thesis's, in the same order, but
// a split costs O(1) and nothing has to be searched for.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace aspect {

// A corner of patches: one camera position on the unit sphere. Ids count up in order of creation
// and so depend on the order of the splits; positions do not.
enum class VertexId : std::uint32_t {};
enum class PatchId : std::uint32_t {};

// Places in arrays by vertex and by patch.
inline std::size_t number(VertexId vertex) {
  return static_cast<std::size_t>(vertex);
}
inline std::size_t number(PatchId patch) {
  return static_cast<std::size_t>(patch);
}

struct Patch {
  std::array<VertexId, 3> corners{};  // counter-clockwise seen from outside
  int level = 0;
  bool split = false;                 // then `children` are its four parts and it is no leaf
  std::array<PatchId, 4> children{};  // at corners 0, 1, 2, then the middle one; where split
};

class ViewSphere {
 public:
  // The regular icosahedron: 12 vertices, (0, +-1, +-phi) and its cyclic permutations normalised,
  // and 20 patches of level 0. The axes pass through midpoints of its edges, so (+-1, 0, 0),
  // (0, +-1, 0) and (0, 0, +-1) are vertices of level 1. The thesis's has vertices at (0, 0, +-1)
  // and (2, 0, 1) / sqrt(5) instead, as the vertices listed in its A.2.5 and A.2.6 show.
  ViewSphere();

  // Splits a leaf into four: child k keeps corner k in place k, the middle child's corner k is the
  // midpoint opposite corner k. A midpoint is the normalised sum of its two ends, and the one that
  // a neighbour has made already is reused. Its bits depend on its ends only: neither on which side
  // was split first nor on the machine. O(1); invalidates references to patches and positions.
  void split(PatchId leaf);

  const Eigen::Vector3d& position(VertexId vertex) const;
  const Patch& patch(PatchId patch) const;
  std::size_t vertex_count() const { return vertices_.size(); }
  std::size_t patch_count() const { return patches_.size(); }  // leaves and split ones

  // Leaves in a fixed order: depth first, children in order. The order does not depend on the order
  // of the splits.
  std::vector<PatchId> leaves() const;

  // The leaves that share a piece of an edge with this leaf (touching in a point is not enough),
  // going round from corner 0 along (0,1), (1,2), (2,0); each once, since two patches never share
  // pieces of two edges. O(level + number of neighbours).
  std::vector<PatchId> neighbours(PatchId leaf) const;

  // Solid angle of the spherical triangle, in steradians (the whole sphere: 4 pi).
  double area_sr(PatchId patch) const;

  // The same as a share of the whole sphere.
  double share(PatchId patch) const { return area_sr(patch) / (4 * std::numbers::pi); }

  // The leaf in which a direction of any length but zero lies (on a border: one of those that touch
  // it). O(level).
  PatchId locate(const Eigen::Vector3d& direction) const;

 private:
  // Edge k of a patch runs from corner k to the next one.
  struct Links {
    PatchId parent;                 // none for level 0
    std::array<PatchId, 3> across;  // by edge: the patch of the same level; none until it exists
  };

  const Links& links(PatchId patch) const;
  Links& links(PatchId patch);
  PatchId add_patch(const std::array<VertexId, 3>& corners, int level, PatchId parent);
  void link_level_0();
  void link_children(PatchId parent);
  std::size_t edge_towards(PatchId patch, PatchId neighbour) const;
  VertexId midpoint(PatchId patch, std::size_t edge);
  double triple_product(VertexId a, VertexId b, const Eigen::Vector3d& c) const;
  void append_leaves(PatchId patch, std::vector<PatchId>& found) const;
  void append_along(PatchId patch, std::size_t edge, std::vector<PatchId>& found) const;

  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Patch> patches_;
  std::vector<Links> links_;  // beside patches_
};

}  // namespace aspect
