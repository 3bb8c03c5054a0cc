#include "compiler/scene/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "compiler/scene/bob_sources.h"
#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/mesh_text.h"
#include "compiler/scene/named_file.h"

namespace aspect {
namespace {

using Json = GltfFile::Json;

constexpr std::size_t kMaxBufferBytes = std::size_t{1} << 30;

// What changes neither where a surface is nor what its colour is, or is read here.
constexpr std::array<std::string_view, 22> kRead = {"EXT_texture_webp",
                                                    "KHR_animation_pointer",
                                                    "KHR_lights_punctual",
                                                    "KHR_materials_anisotropy",
                                                    "KHR_materials_clearcoat",
                                                    "KHR_materials_diffuse_transmission",
                                                    "KHR_materials_dispersion",
                                                    "KHR_materials_emissive_strength",
                                                    "KHR_materials_ior",
                                                    "KHR_materials_iridescence",
                                                    "KHR_materials_pbrSpecularGlossiness",
                                                    "KHR_materials_sheen",
                                                    "KHR_materials_specular",
                                                    "KHR_materials_transmission",
                                                    "KHR_materials_unlit",
                                                    "KHR_materials_variants",
                                                    "KHR_materials_volume",
                                                    "KHR_mesh_quantization",
                                                    "KHR_texture_transform",
                                                    "KHR_xmp",
                                                    "KHR_xmp_json_ld",
                                                    "MSFT_lod"};

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k)
    word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + k])} << 8 * k;
  return word;
}

struct Chunks {
  std::string_view json, binary;
};

Chunks chunks_of(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return {without_byte_order_mark(bytes), {}};
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  if (bytes.size() < 12 || word_at(bytes, 4) != 2)
    throw MeshError("is no binary glTF of version 2; export it as 2.0");
  Chunks chunks;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t length = word_at(bytes, at);
    const std::uint32_t kind = word_at(bytes, at + 4);
    if (length > bytes.size() - at - 8) throw MeshError("ends before its data do; export it again");
    const std::string_view chunk = bytes.substr(at + 8, length);
    if (kind == kJson && chunks.json.empty()) chunks.json = chunk;
    if (kind == kBinary && chunks.binary.empty()) chunks.binary = chunk;
    at += 8 + length;
  }
  return chunks;
}

Json parsed(std::string_view text) {
  Json root = Json::parse(text, nullptr, false);
  if (!root.is_object()) throw MeshError("holds no glTF (its JSON is broken); export it again");
  return root;
}

std::string version_of(const Json& root) {
  const Json* asset = object_member(&root, "asset");
  return asset != nullptr ? text_member(*asset, "version") : "";
}

void refuse_unknown_extensions(const Json& root) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end() || !required->is_array()) return;
  for (const Json& name : *required) {
    const std::string text = name.is_string() ? name.get<std::string>() : name.dump();
    if (std::find(kRead.begin(), kRead.end(), text) == kRead.end())
      throw MeshError(
          fmt::format("requires {}, which is not read; export it without", shown(text)));
  }
}

std::optional<std::string> base64_bytes(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+' || c == '-' ? 62
                      : c == '/' || c == '_' ? 63
                                             : -1;
    if (digit < 0) return std::nullopt;
    word = word << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(word >> bits & 255u);
  }
  return bytes;
}

std::string without_percents(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string text;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    const bool coded =
        uri[k] == '%' && k + 2 < uri.size() && digit(uri[k + 1]) >= 0 && digit(uri[k + 2]) >= 0;
    text += coded ? static_cast<char>(16 * digit(uri[k + 1]) + digit(uri[k + 2])) : uri[k];
    if (coded) k += 2;
  }
  return text;
}

}  // namespace

std::optional<std::size_t> whole_member(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return std::nullopt;
  if (!found->is_number_unsigned())
    throw MeshError(fmt::format("{} is no whole number; export it again", key));
  return found->get<std::size_t>();
}

std::string text_member(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::vector<double> number_members(const Json& object, const char* key) {
  std::vector<double> numbers;
  const auto found = object.find(key);
  if (found == object.end()) return numbers;
  if (!found->is_array() || found->size() > 16)
    throw MeshError(fmt::format("{} is no list of numbers; export it again", key));
  for (const Json& number : *found) {
    if (!number.is_number())
      throw MeshError(fmt::format("{} is no list of numbers; export it again", key));
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

const Json* object_member(const Json* object, const char* key) {
  if (object == nullptr || !object->is_object()) return nullptr;
  const auto found = object->find(key);
  return found != object->end() && found->is_object() ? &*found : nullptr;
}

GltfFile::GltfFile(std::string_view bytes, const std::filesystem::path& file) : file_(file) {
  const Chunks chunks = chunks_of(bytes);
  root_ = parsed(chunks.json);
  binary_ = chunks.binary;
  const std::string version = version_of(root_);
  if (!version.starts_with("2."))
    throw MeshError(fmt::format("is glTF of version '{}'; export it as 2.0", shown(version)));
  refuse_unknown_extensions(root_);
}

const Json* GltfFile::find(std::string_view list, std::size_t index) const {
  const auto found = root_.find(list);
  if (found == root_.end() || !found->is_array() || index >= found->size()) return nullptr;
  return (*found)[index].is_object() ? &(*found)[index] : nullptr;
}

const Json& GltfFile::at(std::string_view list, std::size_t index, std::string_view user) const {
  const Json* found = find(list, index);
  if (found == nullptr)
    throw MeshError(
        fmt::format("{} names {}[{}], which is not there; export it again", user, list, index));
  return *found;
}

std::string_view GltfFile::buffer_view(std::size_t index) {
  const Json& view = at("bufferViews", index, "an accessor or image");
  const std::optional<std::size_t> buffer_index = whole_member(view, "buffer");
  const std::size_t offset = whole_member(view, "byteOffset").value_or(0);
  const std::size_t length = whole_member(view, "byteLength").value_or(0);
  if (!buffer_index) throw MeshError("a bufferView without a buffer; export it again");
  const std::string_view bytes =
      *buffer_index == 0 && !binary_.empty() && !at("buffers", 0, "a bufferView").contains("uri")
          ? binary_
          : std::string_view(buffer(*buffer_index));
  if (offset > bytes.size() || length > bytes.size() - offset)
    throw MeshError(
        fmt::format("bufferViews[{}] is larger than its buffer; export it again", index));
  return bytes.substr(offset, length);
}

const std::string& GltfFile::buffer(std::size_t index) {
  const auto [place, added] = buffers_.try_emplace(index);
  if (!added) return place->second;
  const std::string uri = text_member(at("buffers", index, "a bufferView"), "uri");
  std::optional<std::string> bytes = resource(uri, kMaxBufferBytes);
  if (!bytes)
    throw MeshError(fmt::format("buffer '{}' is not there; put it beside the file", shown(uri)));
  return place->second = std::move(*bytes);
}

std::optional<std::string> GltfFile::resource(const std::string& uri, std::size_t most_bytes) {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(";base64,");
    if (comma == std::string::npos) return std::nullopt;
    return base64_bytes(std::string_view(uri).substr(comma + 8));
  }
  std::optional<NamedFile> found =
      find_named_file(file_.parent_path(), without_percents(uri), asked_);
  if (!found) found = find_named_file(file_.parent_path(), uri, asked_);
  if (!found) return std::nullopt;
  Result<std::string> bytes = load_text(found->path, most_bytes);
  if (!bytes) throw MeshError(bytes.error(), 0, found->path.string());
  return std::move(bytes).value();
}

}  // namespace aspect
