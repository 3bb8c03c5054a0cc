#include "compiler/scene/ply_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "compiler/scene/mesh_text.h"
#include "compiler/scene/named_file.h"
#include "compiler/scene/textured_faces.h"

namespace aspect {
namespace {

class PlyPictures {
 public:
  PlyPictures(std::span<const PlyTexture> textures, const std::filesystem::path& folder)
      : textures_(textures), folder_(folder), told_(textures.size()) {}

  // Null where it is not found, which is told once.
  TexturedFaces::Picture* find(std::size_t texture, ColouredMesh& mesh) {
    const PlyTexture& named = textures_[texture];
    TexturedFaces::Picture& picture = faces_.picture(named.name, [&] { return load(named, mesh); });
    if (picture.texture) return &picture;
    if (!told_[texture])
      mesh.missing.push_back({{},
                              named.line,
                              fmt::format("texture '{}' {}", shown(named.name), picture.fault),
                              "put it beside the mesh",
                              {0}});
    told_[texture] = true;
    return nullptr;
  }

  void add_to(ColouredMesh& mesh) const { faces_.add_to(mesh); }

 private:
  std::vector<std::uint8_t> load(const PlyTexture& texture, ColouredMesh& mesh) {
    const std::optional<NamedFile> found = find_named_file(folder_, texture.name, mesh.files);
    if (!found) throw MeshError("is not there");
    if (found->guessed)
      mesh.warnings.push_back(fmt::format("texture '{}' of line {} is taken to be {}",
                                          shown(texture.name), texture.line, found->path.string()));
    return load_picture(found->path);
  }

  std::span<const PlyTexture> textures_;
  const std::filesystem::path& folder_;
  TexturedFaces faces_;
  std::vector<bool> told_;  // by texture
};

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
                   const std::filesystem::path& folder, const Eigen::Vector3d& stand_in) {
  PlyPictures pictures(textures, folder);
  std::vector<Eigen::Vector3d> places;
  for (const PlyFaces::Face& face : faces.faces) {
    const auto corners = std::span(faces.corners).subspan(face.begin, face.count);
    const bool plain = face.texture == PlyFaces::kPlain;
    TexturedFaces::Picture* picture =
        plain ? nullptr : pictures.find(static_cast<std::size_t>(face.texture), mesh);
    if (picture == nullptr) {
      add_face(mesh, corners, plain ? face.colour : stand_in, 0);
      continue;
    }
    places.clear();
    for (const std::uint32_t corner : corners) places.push_back(mesh.vertices[corner]);
    const auto coordinates = std::span(faces.texcoords).subspan(face.begin, face.count);
    TexturedFaces::add(*picture, places, coordinates, {}, 0);
  }
  pictures.add_to(mesh);
}

}  // namespace aspect
