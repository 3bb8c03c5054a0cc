// Reader of the surfaces in an ASCII DXF file.
//
// Why our own: measured on the samples of its test, Assimp 5.2 gives numbers above 10, true colours
// (420) and colours of layers (BYLAYER) as grey, and dxflib 3.26 hands over a vertex without its
// flags and indices (70 to 74), so that no polyface mesh can be read with it.
#pragma once

#include <string_view>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// 3DFACE, SOLID, TRACE, POLYLINE as polyface and as M x N mesh, and INSERT of blocks, nested, with
// scale, rotation, rows and columns. A part is a layer. Colours: of the entity (420, then 62), of
// its layer, of its INSERT (BYBLOCK). Solids that only a modeller understands (3DSOLID, BODY,
// REGION, SURFACE, MESH) are a warning. Throws MeshError.
ColouredMesh parse_dxf(std::string_view file);

}  // namespace aspect
