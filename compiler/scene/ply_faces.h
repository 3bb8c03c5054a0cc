// A PLY file's faces, before the pictures on them are cut into triangles of one colour.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/ply_header.h"

namespace aspect {

struct PlyFaces {
  static constexpr int kPlain = -1;

  struct Face {
    std::size_t begin = 0;  // of its corners, and of their texture coordinates
    std::uint32_t count = 0;
    int texture = kPlain;    // its number among the file's
    Eigen::Vector3d colour;  // where it has no texture
  };
  std::vector<Face> faces;
  std::vector<std::uint32_t> corners;      // vertices
  std::vector<Eigen::Vector2d> texcoords;  // of corners; shorter where the last have none

  // A face without a texture; coordinates go to the last face.
  void add(std::span<const std::uint32_t> face_corners, const Eigen::Vector3d& colour);
  void set_texture(std::size_t face, int texture, std::span<const Eigen::Vector2d> coordinates);
};

// The faces of part 0: plain ones first, then by the names of textures, which are looked for in
// `folder` where a face has them. Those whose texture is not found have the colour `stand_in`, and
// it is in mesh.missing. Throws MeshError.
void add_ply_faces(ColouredMesh& mesh, const PlyFaces& faces, std::span<const PlyTexture> textures,
                   const std::filesystem::path& folder, const Eigen::Vector3d& stand_in);

}  // namespace aspect
