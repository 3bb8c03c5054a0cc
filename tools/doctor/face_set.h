// The flat faces of a model, whatever it was read from, with corners at one place made one.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/scene.h"

namespace aspect {

struct FaceSet {
  struct Face {
    std::size_t first = 0, count = 0;  // of its corners
    std::size_t number = 0;            // from 0: triangle of the mesh, primitive of the scene
    Eigen::Vector3d colour{0, 0, 0};
  };

  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::uint32_t> corners;  // indices of vertices, face by face
  std::vector<Face> faces;
  std::size_t cracked = 0;  // vertices that were a little off the one that stands for them
  std::vector<std::uint32_t> cracks;  // some of those that stand for them
  double tolerance = 0;               // up to where vertices are at one place
  double diameter = 0;                // of the box about them all
  bool wound = false;  // whether the order of corners says which side is the outer one

  std::span<const std::uint32_t> corners_of(std::size_t face) const {
    return {corners.data() + faces[face].first, faces[face].count};
  }
};

// Every coordinate of a vertex that is used must be finite.
FaceSet face_set_of(const ColouredMesh& mesh);

// Of its polygons and smooth triangles; round shapes have no edges to be judged here.
FaceSet face_set_of(const Scene& scene);

}  // namespace aspect
