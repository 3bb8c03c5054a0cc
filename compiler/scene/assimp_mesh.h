// Mesh files through Assimp: text STL, 3DS, textured PLY.
#pragma once

#include <filesystem>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// A face's colour is its texture's or its corners' mean where the file has them, otherwise its
// material's. Vertices are in the file's coordinates, as its nodes place
// them. Not read: texture transforms, clamped textures, skins. Throws MeshError.
ColouredMesh read_with_assimp(const std::filesystem::path& file,
                              const Eigen::Vector3d& stand_in = kUncoloured);

}  // namespace aspect
