#include "compiler/scene/textured_faces.h"

#include <Eigen/Geometry>
#include <fstream>

#include "compiler/scene/ear_clipping.h"

namespace aspect {
namespace {

// Borders in textures are jagged by this share of the object's size: 3 pixels of 512.
constexpr double kLeastEdge = 0.01;
constexpr std::uintmax_t kMaxPictureBytes = std::uintmax_t{256} << 20;

}  // namespace

TexturedFaces::Picture& TexturedFaces::picture(
    const std::string& name, const std::function<std::vector<std::uint8_t>()>& load) {
  const auto [place, added] = pictures_.try_emplace(name);
  if (!added) return place->second;
  try {
    place->second.texture = decode_texture(load());
  } catch (const MeshError& error) {
    place->second.fault = error.what();
  }
  return place->second;
}

void TexturedFaces::add(Picture& picture, std::span<const Eigen::Vector3d> corners,
                        std::span<const Eigen::Vector2d> uv, const PictureFactor& factor,
                        std::uint32_t part) {
  const std::vector<Eigen::Vector3d> polygon(corners.begin(), corners.end());
  if (polygon.size() < 3) return;
  if (polygon.size() > ColouredMesh::kMaxFaceCorners)
    throw MeshError("a face of too many corners; write triangles");
  for (const Eigen::Vector3d& corner : polygon)
    if (!corner.allFinite()) throw MeshError("a vertex is not finite; export it again");
  std::vector<Triangle> triangles = {{0, 1, 2}};
  if (polygon.size() > 3) triangles = triangulate(polygon);
  for (const Triangle& triangle : triangles) {
    TexturedTriangle& made = picture.triangles.emplace_back();
    made.part = part;
    made.factor = factor.factor;
    made.linear_factor = factor.linear;
    for (std::size_t k = 0; k < 3; ++k) {
      made.corners[k] = polygon[triangle[k]];
      made.uv[k] = uv[triangle[k]];
    }
  }
}

void TexturedFaces::add_to(ColouredMesh& mesh) const {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  const double least_edge = kLeastEdge * (box.isEmpty() ? 1 : box.diagonal().norm());
  for (const auto& [name, picture] : pictures_)
    if (picture.texture) add_textured(mesh, picture.triangles, *picture.texture, least_edge);
}

std::vector<std::uint8_t> load_picture(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) throw MeshError("is not there");
  if (std::filesystem::file_size(file, unknown) > kMaxPictureBytes) throw MeshError("is too large");
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace aspect
