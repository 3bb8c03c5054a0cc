// The faces of a mesh that show pictures, until all of them are known.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/mesh_texture.h"

namespace aspect {

// How a picture's colours are changed by a face's own.
struct PictureFactor {
  Eigen::Vector3d factor{1, 1, 1};
  bool linear = false;  // of light; otherwise of the colours as displayed
};

class TexturedFaces {
 public:
  struct Picture {
    std::optional<MeshTexture> texture;
    std::string fault;  // of one that is not there or not read: "is not there"
    std::vector<TexturedTriangle> triangles;
  };

  // The picture of a name, which outlives others; loaded when it is first asked for.
  Picture& picture(const std::string& name, const std::function<std::vector<std::uint8_t>()>& load);

  // A face with any number of corners that shows a picture that is there. Throws MeshError.
  static void add(Picture& picture, std::span<const Eigen::Vector3d> corners,
                  std::span<const Eigen::Vector2d> uv, const PictureFactor& factor,
                  std::uint32_t part);

  // Cuts all of them into triangles of one colour each, by the order of the pictures' names. The
  // mesh's vertices say how large the object is.
  void add_to(ColouredMesh& mesh) const;

 private:
  std::map<std::string, Picture> pictures_;
};

// A picture's bytes as its file holds them. Throws MeshError.
std::vector<std::uint8_t> load_picture(const std::filesystem::path& file);

}  // namespace aspect
