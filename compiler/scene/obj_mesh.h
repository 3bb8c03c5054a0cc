// OBJ files and their materials.
#pragma once

#include <filesystem>
#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// A face's colour is its material's picture, or its corners' mean where they have colours, or its
// material's; a part is what one object or group has of one material. `file` is where libraries are
// looked for; `stand_in` colours faces whose colour is not found. Not read: free-form surfaces,
// clamped textures. Throws MeshError. Format: Wavefront's "Object Files (.obj)", 1995, with colours
// behind a vertex's coordinates as MeshLab writes them.
ColouredMesh parse_obj(std::string_view text, const std::filesystem::path& file,
                       const Eigen::Vector3d& stand_in = kUncoloured);

}  // namespace aspect
