#include "compiler/scene/ply_faces.h"

#include <fmt/format.h>

#include <algorithm>

namespace aspect {
namespace {

MeshTexture read(const PlyTexture& texture, const TextureSource& texture_of) {
  try {
    return texture_of(texture.name);
  } catch (const MeshError& error) {
    throw MeshError(fmt::format("texture '{}' {}", shown(texture.name), error.what()),
                    texture.line);
  }
}

}  // namespace

void PlyFaces::add(std::span<const std::uint32_t> face_corners, const Eigen::Vector3d& colour) {
  faces.push_back(
      {corners.size(), static_cast<std::uint32_t>(face_corners.size()), kPlain, colour});
  corners.insert(corners.end(), face_corners.begin(), face_corners.end());
}

void PlyFaces::set_texture(std::size_t face, int texture,
                           std::span<const Eigen::Vector2d> coordinates) {
  faces[face].texture = texture;
  const std::size_t begin = faces[face].begin;
  texcoords.resize(std::max(texcoords.size(), begin + coordinates.size()));
  std::copy(coordinates.begin(), coordinates.end(),
            texcoords.begin() + static_cast<std::ptrdiff_t>(begin));
}

void add_ply_faces(ColouredMesh& mesh, const PlyFaces& faces, std::span<const PlyTexture> textures,
                   const TextureSource& texture_of) {
  std::vector<std::vector<TexturedTriangle>> textured(textures.size());
  for (const PlyFaces::Face& face : faces.faces) {
    const auto corners = std::span(faces.corners).subspan(face.begin, face.count);
    if (face.texture == PlyFaces::kPlain) {
      add_face(mesh, corners, face.colour, 0);
      continue;
    }
    for (const auto& places : cut_face(mesh, corners)) {
      TexturedTriangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.corners[k] = mesh.vertices[corners[places[k]]];
        triangle.uv[k] = faces.texcoords[face.begin + places[k]];
      }
      textured.at(static_cast<std::size_t>(face.texture)).push_back(triangle);
    }
  }
  const double least_edge = least_texture_edge(mesh);
  for (std::size_t k = 0; k < textures.size(); ++k)
    if (!textured[k].empty())
      add_textured(mesh, textured[k], read(textures[k], texture_of), least_edge);
}

}  // namespace aspect
