#include "compiler/scene/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "compiler/scene/bob_reader.h"
#include "compiler/scene/mesh_reader.h"

namespace aspect {

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& letter : extension)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return extension;
}

Result<Scene> read_scene(const std::filesystem::path& file, const SceneReading& reading) {
  constexpr std::array<std::string_view, 11> kMeshes = {
      ".obj", ".ply", ".stl", ".gltf", ".glb", ".dxf", ".off", ".3ds", ".3mf", ".step", ".stp"};
  const std::string extension = lower_extension(file);
  if (extension == ".b") return read_bob(file, reading.include_path, reading.colours.missing);
  if (std::find(kMeshes.begin(), kMeshes.end(), extension) != kMeshes.end())
    return read_mesh(file, reading.colours, reading.chord_error);
  return Error{fmt::format("{}: unknown extension '{}'; give one of .b {}", file.string(),
                           extension, fmt::join(kMeshes, " "))};
}

}  // namespace aspect
