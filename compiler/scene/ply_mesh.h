// Reader of PLY files with their colours: Assimp 5.2 loses those of faces (measured).
#pragma once

#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// Text and binary of either byte order (paulbourke.net/dataformats/ply). A face's own colour wins
// over those of its corners, of which the mean is taken. Names: red, green, blue, also with
// diffuse_ in front, or r, g, b. Throws MeshError.
ColouredMesh parse_ply(std::string_view file);

// Whether its header names texture coordinates or a texture, which parse_ply() does not read.
bool is_textured_ply(std::string_view file);

}  // namespace aspect
