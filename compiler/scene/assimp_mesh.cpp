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
#include <optional>
#include <set>

#include "compiler/scene/bob_sources.h"
#include "compiler/scene/mesh_text.h"
#include "compiler/scene/named_file.h"
#include "compiler/scene/scene_reader.h"
#include "compiler/scene/tds_materials.h"
#include "compiler/scene/textured_faces.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

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

constexpr std::size_t kMax3dsBytes = std::size_t{1} << 30;
constexpr std::size_t kMostTold = 100;
constexpr const char* kNo3dsMaterial = "%%%DEFAULT";

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
                      material.name != kNo3dsMaterial &&
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
  AssimpReader(const std::filesystem::path& file, const Vector3d& stand_in)
      : file_(file), stand_in_(stand_in) {
    is_3ds_ = lower_extension(file) == ".3ds";
  }

  ColouredMesh read() {
    Assimp::Importer importer;
    importer.SetIOHandler(new NotedFiles(files_));  // which the importer then owns
    find_undefined_materials();
    scene_ = importer.ReadFile(file_.string(), 0);
    if (scene_ == nullptr || scene_->mRootNode == nullptr)
      throw MeshError(
          fmt::format("cannot be read ({}); export it again", shown(importer.GetErrorString())));
    for (unsigned k = 0; k < scene_->mNumMaterials; ++k)
      materials_.push_back(material_of(*scene_->mMaterials[k]));
    add_nodes();
    textured_.add_to(mesh_);
    warn_of_uncoloured(mesh_, uncoloured_, faces_);
    mesh_.files.insert(mesh_.files.end(), files_.begin(), files_.end());
    return std::move(mesh_);
  }

 private:
  // Assimp gives what has them a material of its own.
  void find_undefined_materials() {
    if (!is_3ds_) return;
    const Result<std::string> bytes = load_text(file_, kMax3dsBytes);
    if (!bytes) throw MeshError(bytes.error());
    for (const std::string& name : undefined_tds_materials(bytes.value())) {
      if (undefined_.size() == kMostTold) break;
      undefined_.push_back(mesh_.missing.size());
      mesh_.missing.push_back(
          {{}, 0, fmt::format("material '{}' is not defined", shown(name)), "export it with it"});
    }
  }

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
    Material material;
    if (source.mMaterialIndex < materials_.size()) material = materials_[source.mMaterialIndex];
    const auto part = static_cast<std::uint32_t>(mesh_.parts.size());
    const char* name = source.mName.length > 0 ? source.mName.C_Str() : node.mName.C_Str();
    mesh_.parts.push_back({name, material.name});
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (unsigned k = 0; k < source.mNumVertices; ++k) {
      const aiVector3D& v = source.mVertices[k];
      add_vertex(mesh_, placed * Vector3d(static_cast<double>(v.x), static_cast<double>(v.y),
                                          static_cast<double>(v.z)));
    }
    const bool has_uv = source.HasTextureCoords(material.uv_channel);
    TexturedFaces::Picture* picture = picture_of(material, has_uv, part);
    if (picture == nullptr && !material.texture.empty()) material.colour = stand_in_;
    if (!undefined_.empty() && material.name == kNo3dsMaterial) {
      material.colour = stand_in_;
      for (const std::size_t missing : undefined_) mesh_.missing[missing].parts.push_back(part);
    }
    const bool coloured = !undefined_.empty() || material.coloured || !material.texture.empty() ||
                          source.HasVertexColors(0);
    for (unsigned k = 0; k < source.mNumFaces; ++k) {
      const aiFace& face = source.mFaces[k];
      if (face.mNumIndices < 3) continue;
      ++faces_;
      if (!coloured) ++uncoloured_;
      for (unsigned c = 0; c < face.mNumIndices; ++c)
        if (face.mIndices[c] >= source.mNumVertices)
          throw MeshError("a face has a vertex that is not there; export it again");
      if (picture != nullptr)
        add_textured_face(source, face, first, material, *picture, part);
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
    if (source.HasVertexColors(0)) colour = mean;
    add_face(mesh_, corners, colour, part);
  }

  void add_textured_face(const aiMesh& source, const aiFace& face, std::uint32_t first,
                         const Material& material, TexturedFaces::Picture& picture,
                         std::uint32_t part) {
    std::vector<Vector3d> places;
    std::vector<Vector2d> uv;
    for (unsigned c = 0; c < face.mNumIndices; ++c) {
      const aiVector3D& at = source.mTextureCoords[material.uv_channel][face.mIndices[c]];
      places.push_back(mesh_.vertices[first + face.mIndices[c]]);
      uv.emplace_back(static_cast<double>(at.x), static_cast<double>(at.y));
    }
    PictureFactor factor;
    // Many writers leave the colour beside a texture black.
    if (!material.colour.isZero() && material.coloured) factor.factor = material.colour;
    TexturedFaces::add(picture, places, uv, factor, part);
  }

  // Null where the material has none, or one that is not there: that is told.
  TexturedFaces::Picture* picture_of(const Material& material, bool has_uv, std::uint32_t part) {
    if (material.texture.empty()) return nullptr;
    TexturedFaces::Picture& picture =
        textured_.picture(material.texture, [&] { return picture_bytes(material.texture); });
    if (picture.texture && has_uv) return &picture;
    const std::string fault =
        picture.texture ? "is on faces without texture coordinates" : picture.fault;
    mesh_.missing.push_back({{},
                             0,
                             fmt::format("texture '{}' {}", shown(material.texture), fault),
                             "put a PNG or JPEG picture there, and export the model with "
                             "texture coordinates",
                             {part}});
    return nullptr;
  }

  std::vector<std::uint8_t> picture_bytes(const std::string& name) {
    if (const aiTexture* embedded = scene_->GetEmbeddedTexture(name.c_str())) {
      if (embedded->mHeight != 0) throw MeshError("is embedded uncompressed; embed PNG or JPEG");
      const auto* first = reinterpret_cast<const std::uint8_t*>(embedded->pcData);
      return {first, first + embedded->mWidth};
    }
    const std::optional<NamedFile> found = find_named_file(file_.parent_path(), name, mesh_.files);
    if (!found) throw MeshError("is not there");
    if (found->guessed)
      mesh_.warnings.push_back(
          fmt::format("texture '{}' is taken to be {}", shown(name), found->path.string()));
    return load_picture(found->path);
  }

  const std::filesystem::path& file_;
  const Vector3d stand_in_;
  bool is_3ds_ = false;
  const aiScene* scene_ = nullptr;
  std::size_t faces_ = 0, uncoloured_ = 0;
  std::vector<Material> materials_;
  std::set<std::string> files_;         // all that the importer asked for
  std::vector<std::size_t> undefined_;  // materials; places in mesh_.missing
  TexturedFaces textured_;
  ColouredMesh mesh_;
};

}  // namespace

ColouredMesh read_with_assimp(const std::filesystem::path& file, const Vector3d& stand_in) {
  return AssimpReader(file, stand_in).read();
}

}  // namespace aspect
