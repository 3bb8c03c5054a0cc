// Reader of OFF files with their colours: Assimp 5.2 loses those of faces and leaves those of
// vertices in 0..255 (measured).
#pragma once

#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// Text OFF with the prefixes ST, C and N (geomview.org, oogl.html#OFF). A face's own colour wins
// over those of its corners, of which the mean is taken. Whole numbers of which one is above 1 are
// 0..255, all others 0..1. A number alone is a place in a map that is not there: `stand_in` has
// such faces. Throws MeshError.
ColouredMesh parse_off(std::string_view text, const Eigen::Vector3d& stand_in = kUncoloured);

}  // namespace aspect
