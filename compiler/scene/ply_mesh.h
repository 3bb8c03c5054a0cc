// Reader of PLY files with their colours: Assimp 5.2 loses those of faces (measured).
#pragma once

#include <filesystem>
#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// Text and binary of either byte order (paulbourke.net/dataformats/ply). A face's texture wins over
// its own colour, and that over those of its corners, of which the mean is taken. Colours: red,
// green, blue, also with diffuse_ in front, or r, g, b. Textures: comment TextureFile for each, and
// coordinates of faces (texcoord, with texnumber, as MeshLab writes them), of vertices (s t, u v,
// with texture_ in front) or in multi_texture_vertex and multi_texture_face; v goes upwards. A
// texture that faces have and that is not found, where `file` lies, is missing and `stand_in` the
// faces' colour. Throws MeshError.
ColouredMesh parse_ply(std::string_view bytes, const std::filesystem::path& file,
                       const Eigen::Vector3d& stand_in = kUncoloured);

// Whether its header names textures, so that other files are needed. Throws MeshError.
bool names_textures(std::string_view ply_bytes);

}  // namespace aspect
