// Reader of 3MF archives with their colours.
//
// Why our own, over minizip and expat: measured on the samples of its test, Assimp 5.2 gives all
// triangles their object's material, whatever group they name.
#pragma once

#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// Millimetres, whatever the file's unit. What the build places is read, with components, also those
// in other model parts; a part of the mesh is a placed object's faces of one material, called as
// the object and the material are. A triangle's colour is the mean of its corners' in its own group
// of <basematerials> or <m:colorgroup>, or in its object's. Those that have none, or of a group
// that is not read (textures, composites), are missing colours. `stand_in` has them. Throws
// MeshError.
ColouredMesh parse_threemf(std::string_view archive, const Eigen::Vector3d& stand_in = kUncoloured);

}  // namespace aspect
