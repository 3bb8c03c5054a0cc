// The viewing sphere as triangles, each of one aspect: what figures of it are drawn from.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/viewsphere/patch_division.h"

namespace aspect {

using PointId = std::uint32_t;

struct SpherePiece {
  std::array<PointId, 3> corners{};  // counter-clockwise seen from outside
  std::int32_t class_id = kNoClass;
};

struct SphereMesh {
  std::vector<Eigen::Vector3d> points;  // of unit length; those of the viewing sphere first
  std::vector<SpherePiece> pieces;      // its leaves, cut where they are divided
  // By pair_of the ends of a side that pieces of a higher level share in halves: its middle.
  std::unordered_map<std::uint64_t, PointId> middles;

  // All points on the piece's sides, its corners among them, counter-clockwise. A side from one to
  // the next is a whole one of the piece on its other side as well.
  std::vector<PointId> rim(const SpherePiece& piece) const;

  double area_sr(const SpherePiece& piece) const;
};

inline std::uint64_t pair_of(PointId a, PointId b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32U | std::max(a, b);
}

// A side that two pieces share.
struct MeshSide {
  PointId from = 0, to = 0;
  std::size_t left = 0, right = 0;  // places in pieces
};

// Each once: the whole mesh has no side that is one piece's alone. O(pieces).
std::vector<MeshSide> sides_of(const SphereMesh& mesh);

SphereMesh sphere_mesh(const ViewSphere& sphere, const SphereClasses& classes);

}  // namespace aspect
