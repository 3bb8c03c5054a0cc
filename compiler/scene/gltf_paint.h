// The colours and pictures of a glTF file's materials.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "compiler/scene/gltf_file.h"
#include "compiler/scene/textured_faces.h"

namespace aspect {

struct GltfPicture {
  std::string place;  // "textures[2]": what messages call it
  std::optional<std::size_t> image;
  std::string fault;  // why there is no image
  std::size_t uv_set = 0;
  Eigen::Affine2d uv_from_file = Eigen::Affine2d::Identity();
  MeshTexture::Wrap wrap_u = MeshTexture::Wrap::repeat, wrap_v = MeshTexture::Wrap::repeat;
};

struct GltfPaint {
  std::string name;                    // of the material
  Eigen::Vector3d factor{1, 1, 1};     // linear
  std::optional<GltfPicture> picture;  // in sRGB
  bool lost = false;                   // the material is not there
};

// Of a material as the format's base colour or, where it has that extension, diffuse colour.
GltfPaint gltf_paint(const GltfFile& gltf, const GltfFile::Json& material);

// The bytes of an image. Throws MeshError: "is not there".
std::vector<std::uint8_t> gltf_image(GltfFile& gltf, std::size_t index);

}  // namespace aspect
