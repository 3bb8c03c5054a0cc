// A glTF 2.0 file: its JSON, and the bytes that this names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

// Throws MeshError. Specification: Khronos glTF 2.0, 2021.
class GltfFile {
 public:
  using Json = nlohmann::json;

  // The text of a .gltf file or the bytes of a .glb file, which must outlive the object. Refuses
  // what the file requires and this library does not read.
  GltfFile(std::string_view bytes, const std::filesystem::path& file);

  const Json& root() const { return root_; }
  // Of one of the lists "meshes", "nodes" and so on; null where it is not there.
  const Json* find(std::string_view list, std::size_t index) const;
  // The same of what must be there; `user` is who names it.
  const Json& at(std::string_view list, std::size_t index, std::string_view user) const;

  std::string_view buffer_view(std::size_t index);
  // The bytes of a data URI, or of a file beside this one. Nothing where it is not there.
  std::optional<std::string> resource(const std::string& uri, std::size_t most_bytes);
  // The paths at which any was looked for.
  const std::vector<std::string>& asked() const { return asked_; }

 private:
  const std::string& buffer(std::size_t index);

  const std::filesystem::path& file_;
  std::vector<std::string> asked_;
  Json root_;
  std::string_view binary_;  // of a .glb file
  std::map<std::size_t, std::string> buffers_;
};

// Of a member; nothing where it is absent. Throws MeshError where it is of another kind.
std::optional<std::size_t> whole_member(const GltfFile::Json& object, const char* key);
std::string text_member(const GltfFile::Json& object, const char* key);
std::vector<double> number_members(const GltfFile::Json& object, const char* key);
// Null where it is absent or no object.
const GltfFile::Json* object_member(const GltfFile::Json* object, const char* key);

}  // namespace aspect
