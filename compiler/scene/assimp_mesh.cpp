#include "compiler/scene/assimp_mesh.h"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/DefaultIOSystem.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "compiler/scene/ear_clipping.h"
#include "compiler/scene/mesh_text.h"
#include "compiler/scene/mesh_texture.h"
#include "compiler/scene/scene_reader.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Borders in textures are jagged by this share of the object's size: 3 pixels of 512.
constexpr double kLeastEdge = 0.01;
constexpr std::uintmax_t kMaxTextureBytes = std::uintmax_t{256} << 20;

Eigen::Affine3d affine(const aiMatrix4x4& m) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (unsigned row = 0; row < 3; ++row)
    for (unsigned column = 0; column < 4; ++column)
      result.matrix()(row, column) = static_cast<double>(m[row][column]);
  return result;
}

// Seven digits, so that the 0.9 of a file is 0.9 again.
Vector3d colour_of(const aiColor4D& colour) {
  const auto channel = [](float value) {
    return std::round(static_cast<double>(value) * 1e7) / 1e7;
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

struct Material {
  std::string name, texture;
  Vector3d colour = kUncoloured;
  bool coloured = false;
  unsigned uv_channel = 0;
};

Material material_of(const aiMaterial& source) {
  Material material;
  aiString text;
  if (source.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) material.name = text.C_Str();
  aiColor4D colour;
  material.coloured = material.name != AI_DEFAULT_MATERIAL_NAME &&
                      source.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS;
  if (material.coloured) material.colour = colour_of(colour);
  if (source.GetTexture(aiTextureType_DIFFUSE, 0, &text) == aiReturn_SUCCESS)
    material.texture = text.C_Str();
  int channel = 0;
  if (source.Get(AI_MATKEY_UVWSRC(aiTextureType_DIFFUSE, 0), channel) == aiReturn_SUCCESS)
    material.uv_channel = static_cast<unsigned>(std::clamp(channel, 0, 7));
  return material;
}

// Files as they are on the disk; keeps the names of all that are asked for.
class NotedFiles : public Assimp::DefaultIOSystem {
 public:
  explicit NotedFiles(std::set<std::string>& names) : names_(names) {}
  bool Exists(const char* name) const override {
    names_.insert(name);
    return DefaultIOSystem::Exists(name);
  }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    names_.insert(name);
    return DefaultIOSystem::Open(name, mode);
  }

 private:
  std::set<std::string>& names_;
};

class AssimpReader {
 public:
  explicit AssimpReader(const std::filesystem::path& file) : file_(file) {
    const std::string extension = lower_extension(file);
    is_3ds_ = extension == ".3ds";
    is_gltf_ = extension == ".gltf" || extension == ".glb";
  }

  ColouredMesh read() {
    Assimp::Importer importer;
    importer.SetIOHandler(new NotedFiles(files_));  // which the importer then owns
    scene_ = importer.ReadFile(file_.string(), 0);
    if (scene_ == nullptr || scene_->mRootNode == nullptr)
      throw MeshError(
          fmt::format("cannot be read ({}); export it again", shown(importer.GetErrorString())));
    for (unsigned k = 0; k < scene_->mNumMaterials; ++k)
      materials_.push_back(material_of(*scene_->mMaterials[k]));
    add_nodes();
    add_textures();
    if (!coloured_) mesh_.warnings.push_back("holds no colours; all of it is grey");
    mesh_.files.assign(files_.begin(), files_.end());
    return std::move(mesh_);
  }

 private:
  void add_nodes() {
    // Assimp turns 3DS files, in which z points upwards, so that y does.
    Eigen::Affine3d file_from_root = Eigen::Affine3d::Identity();
    if (is_3ds_) file_from_root.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    std::vector<std::pair<const aiNode*, Eigen::Affine3d>> open = {
        {scene_->mRootNode, file_from_root}};
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      const Eigen::Affine3d placed = parent * affine(node->mTransformation);
      for (unsigned k = 0; k < node->mNumMeshes; ++k)
        add_mesh(*scene_->mMeshes[node->mMeshes[k]], *node, placed);
      for (unsigned k = node->mNumChildren; k > 0; --k)
        open.emplace_back(node->mChildren[k - 1], placed);
    }
  }

  void add_mesh(const aiMesh& source, const aiNode& node, const Eigen::Affine3d& placed) {
    static const Material kPlain;
    const Material& material =
        source.mMaterialIndex < materials_.size() ? materials_[source.mMaterialIndex] : kPlain;
    const auto part = static_cast<std::uint32_t>(mesh_.parts.size());
    const char* name = source.mName.length > 0 ? source.mName.C_Str() : node.mName.C_Str();
    mesh_.parts.push_back({name, material.name});
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (unsigned k = 0; k < source.mNumVertices; ++k) {
      const aiVector3D& v = source.mVertices[k];
      add_vertex(mesh_, placed * Vector3d(static_cast<double>(v.x), static_cast<double>(v.y),
                                          static_cast<double>(v.z)));
    }
    const MeshTexture* texture =
        source.HasTextureCoords(material.uv_channel) ? texture_of(material) : nullptr;
    coloured_ = coloured_ || material.coloured || texture != nullptr || source.HasVertexColors(0);
    for (unsigned k = 0; k < source.mNumFaces; ++k) {
      const aiFace& face = source.mFaces[k];
      if (face.mNumIndices < 3) continue;
      for (unsigned c = 0; c < face.mNumIndices; ++c)
        if (face.mIndices[c] >= source.mNumVertices)
          throw MeshError("a face has a vertex that is not there; export it again");
      if (texture != nullptr)
        add_textured_face(source, face, first, material, *texture, part);
      else
        add_plain_face(source, face, first, material, part);
    }
  }

  void add_plain_face(const aiMesh& source, const aiFace& face, std::uint32_t first,
                      const Material& material, std::uint32_t part) {
    std::vector<std::uint32_t> corners;
    Vector3d mean = Vector3d::Zero();
    for (unsigned c = 0; c < face.mNumIndices; ++c) {
      corners.push_back(first + face.mIndices[c]);
      if (source.HasVertexColors(0))
        mean += colour_of(source.mColors[0][face.mIndices[c]]) / face.mNumIndices;
    }
    Vector3d colour = material.colour;
    if (source.HasVertexColors(0))
      colour = is_gltf_ && material.coloured ? mean.cwiseProduct(colour).eval() : mean;
    add_face(mesh_, corners, colour, part);
  }

  void add_textured_face(const aiMesh& source, const aiFace& face, std::uint32_t first,
                         const Material& material, const MeshTexture& texture, std::uint32_t part) {
    std::vector<Vector3d> polygon;
    for (unsigned c = 0; c < face.mNumIndices; ++c) {
      polygon.push_back(mesh_.vertices[first + face.mIndices[c]]);
      if (!polygon.back().allFinite() || polygon.size() > ColouredMesh::kMaxFaceCorners)
        throw MeshError("a face has a vertex that is not finite, or too many; export it again");
    }
    std::vector<Triangle> triangles = {{0, 1, 2}};
    if (polygon.size() > 3) triangles = triangulate(polygon);
    for (const Triangle& corners : triangles) {
      TexturedTriangle triangle;
      triangle.part = part;
      // Many writers leave the colour beside a texture black.
      if (!material.colour.isZero() && material.coloured) triangle.factor = material.colour;
      for (std::size_t k = 0; k < 3; ++k) {
        const aiVector3D& uv =
            source.mTextureCoords[material.uv_channel][face.mIndices[corners[k]]];
        triangle.corners[k] = polygon[corners[k]];
        triangle.uv[k] = {static_cast<double>(uv.x), static_cast<double>(uv.y)};
      }
      textured_[&texture].push_back(triangle);
    }
  }

  // In the order of the textures' names.
  void add_textures() {
    Eigen::AlignedBox3d box;
    for (const Vector3d& vertex : mesh_.vertices) box.extend(vertex);
    const double least_edge = kLeastEdge * (box.isEmpty() ? 1 : box.diagonal().norm());
    for (const auto& [name, texture] : textures_)
      if (const auto found = textured_.find(&*texture); texture && found != textured_.end())
        add_textured(mesh_, found->second, *texture, least_edge);
  }

  // Null where the material has none, or one that cannot be read: a warning.
  const MeshTexture* texture_of(const Material& material) {
    if (material.texture.empty()) return nullptr;
    const auto [place, added] = textures_.try_emplace(material.texture);
    if (added) {
      try {
        place->second = decode_texture(texture_bytes(material.texture));
      } catch (const MeshError& error) {
        mesh_.warnings.push_back(fmt::format("texture '{}' {}; the material's colour is used",
                                             shown(material.texture), error.what()));
      }
    }
    return place->second ? &*place->second : nullptr;
  }

  std::vector<std::uint8_t> texture_bytes(std::string name) {
    if (const aiTexture* embedded = scene_->GetEmbeddedTexture(name.c_str())) {
      if (embedded->mHeight != 0) throw MeshError("is embedded uncompressed; embed PNG or JPEG");
      const auto* first = reinterpret_cast<const std::uint8_t*>(embedded->pcData);
      return {first, first + embedded->mWidth};
    }
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path path = file_.parent_path() / name;
    files_.insert(path.string());
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown) ||
        std::filesystem::file_size(path, unknown) > kMaxTextureBytes)
      throw MeshError("is not there");
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  const std::filesystem::path& file_;
  bool is_3ds_ = false, is_gltf_ = false, coloured_ = false;
  const aiScene* scene_ = nullptr;
  std::vector<Material> materials_;
  std::set<std::string> files_;  // all that were asked for
  std::map<std::string, std::optional<MeshTexture>> textures_;
  std::map<const MeshTexture*, std::vector<TexturedTriangle>> textured_;
  ColouredMesh mesh_;
};

}  // namespace

ColouredMesh read_with_assimp(const std::filesystem::path& file) {
  return AssimpReader(file).read();
}

}  // namespace aspect
