#include "compiler/scene/gltf_paint.h"

#include <fmt/format.h>

#include <array>

#include "compiler/scene/mesh_text.h"

namespace aspect {
namespace {

using Json = GltfFile::Json;

constexpr std::size_t kMaxPictureBytes = std::size_t{256} << 20;

// In the order in which they are preferred where there is no plain image.
constexpr std::array<const char*, 1> kReadSources = {"EXT_texture_webp"};

const Json* extension(const Json& object, const char* name) {
  return object_member(object_member(&object, "extensions"), name);
}

MeshTexture::Wrap wrap_of(const Json* sampler, const char* key) {
  constexpr std::size_t kClamp = 33071, kMirror = 33648;
  const std::size_t mode = sampler != nullptr ? whole_member(*sampler, key).value_or(0) : 0;
  return mode == kClamp    ? MeshTexture::Wrap::clamp
         : mode == kMirror ? MeshTexture::Wrap::mirror
                           : MeshTexture::Wrap::repeat;
}

// KHR_texture_transform: scaled, turned, then moved; v points downwards, so a turn that is seen as
// counter-clockwise is clockwise in its numbers.
Eigen::Affine2d transform_of(const Json& transform) {
  const std::vector<double> offset = number_members(transform, "offset"),
                            scale = number_members(transform, "scale");
  const auto turn = transform.find("rotation");
  Eigen::Affine2d moved = Eigen::Affine2d::Identity();
  if (offset.size() == 2) moved.translate(Eigen::Vector2d(offset[0], offset[1]));
  if (turn != transform.end() && turn->is_number()) moved.rotate(-turn->get<double>());
  if (scale.size() == 2) moved.scale(Eigen::Vector2d(scale[0], scale[1]));
  return moved;
}

// The image of a texture, or why there is none.
void find_image(const GltfFile& gltf, const Json& texture, GltfPicture& picture) {
  picture.image = whole_member(texture, "source");
  for (const char* name : kReadSources)
    if (const Json* other = extension(texture, name); other != nullptr && !picture.image)
      picture.image = whole_member(*other, "source");
  if (picture.image && gltf.find("images", *picture.image) == nullptr) {
    picture.fault = fmt::format("names images[{}], which is not there", *picture.image);
    picture.image.reset();
  } else if (!picture.image) {
    const Json* extensions = object_member(&texture, "extensions");
    picture.fault = extensions != nullptr && !extensions->empty()
                        ? fmt::format("has an image of {} alone, which is not read",
                                      shown(extensions->begin().key()))
                        : "names no image";
  }
}

GltfPicture picture_of(const GltfFile& gltf, const Json& info) {
  GltfPicture picture;
  picture.uv_set = whole_member(info, "texCoord").value_or(0);
  if (const Json* transform = extension(info, "KHR_texture_transform")) {
    picture.uv_from_file = transform_of(*transform);
    picture.uv_set = whole_member(*transform, "texCoord").value_or(picture.uv_set);
  }
  const std::optional<std::size_t> index = whole_member(info, "index");
  picture.place = index ? fmt::format("textures[{}]", *index) : "a texture without index";
  const Json* texture = index ? gltf.find("textures", *index) : nullptr;
  if (texture == nullptr) {
    picture.fault = "is not there";
    return picture;
  }
  find_image(gltf, *texture, picture);
  const std::optional<std::size_t> sampler = whole_member(*texture, "sampler");
  const Json* wrap = sampler ? gltf.find("samplers", *sampler) : nullptr;
  picture.wrap_u = wrap_of(wrap, "wrapS");
  picture.wrap_v = wrap_of(wrap, "wrapT");
  return picture;
}

}  // namespace

GltfPaint gltf_paint(const GltfFile& gltf, const Json& material) {
  GltfPaint paint;
  paint.name = text_member(material, "name");
  const Json* diffuse = extension(material, "KHR_materials_pbrSpecularGlossiness");
  const Json* source =
      diffuse != nullptr ? diffuse : object_member(&material, "pbrMetallicRoughness");
  if (source == nullptr) return paint;
  const std::vector<double> factor =
      number_members(*source, diffuse != nullptr ? "diffuseFactor" : "baseColorFactor");
  if (factor.size() >= 3) paint.factor = {factor[0], factor[1], factor[2]};
  if (const Json* info =
          object_member(source, diffuse != nullptr ? "diffuseTexture" : "baseColorTexture"))
    paint.picture = picture_of(gltf, *info);
  return paint;
}

std::vector<std::uint8_t> gltf_image(GltfFile& gltf, std::size_t index) {
  const Json& image = gltf.at("images", index, "a texture");
  std::string bytes;
  if (const auto view = whole_member(image, "bufferView")) {
    bytes = gltf.buffer_view(*view);
  } else {
    std::optional<std::string> found = gltf.resource(text_member(image, "uri"), kMaxPictureBytes);
    if (!found) throw MeshError("is not there");
    bytes = std::move(*found);
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace aspect
