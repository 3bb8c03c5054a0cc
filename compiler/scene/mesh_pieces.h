// A mesh cut into its pieces: triangles of one colour that are joined by edges.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"

namespace aspect {

struct SurfaceTriangle {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t surface = 0;
  std::uint32_t part = 0;  // of the mesh; says nothing of what is one piece
};

// Makes vertices at the same place one, and leaves out triangles without area and repeated ones.
void weld(std::vector<Eigen::Vector3d>& vertices, std::vector<SurfaceTriangle>& triangles);

// By triangle: its piece, numbered in the order of their first triangles. By edges: an edge also
// joins those that its middle cuts it into, as it does where textures are cut. The vertices are
// welded.
std::vector<std::uint32_t> pieces_by_edges(const std::vector<Eigen::Vector3d>& vertices,
                                           const std::vector<SurfaceTriangle>& triangles);
std::vector<std::uint32_t> pieces_by_surface(const std::vector<SurfaceTriangle>& triangles);

// A primitive a piece.
std::vector<Primitive> primitives_of(const std::vector<Eigen::Vector3d>& vertices,
                                     const std::vector<SurfaceTriangle>& triangles,
                                     const std::vector<std::uint32_t>& piece_of);

}  // namespace aspect
