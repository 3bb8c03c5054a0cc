// The picture files that meshes name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aspect {

// The bytes of the picture that a mesh in `folder` calls `name`: there, or, where the name is a
// path of another machine, its last part beside the mesh. Throws MeshError that goes on behind the
// name.
std::vector<std::uint8_t> load_texture(const std::filesystem::path& folder, std::string name);

}  // namespace aspect
