// glTF 2.0 files, as text or binary.
#pragma once

#include <filesystem>
#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// Triangles as the nodes of the default scene place them; a part is what one node has of one
// primitive. Colours are brought from light to what is displayed (colour_meaning.h): a face's is
// its picture's or 1, times the material's base colour, times its corners' mean. `file` is where
// buffers and images are looked for; `stand_in` colours faces whose colour is not found. Not read:
// skins, morph targets, points and lines. Throws MeshError, also where the file requires an
// extension that is not read. Specification: Khronos glTF 2.0, 2021.
ColouredMesh parse_gltf(std::string_view bytes, const std::filesystem::path& file,
                        const Eigen::Vector3d& stand_in = kUncoloured);

}  // namespace aspect
