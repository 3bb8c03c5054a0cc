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
// scale, rotation, rows and columns. Thickness (group 39) makes walls of LINE, ARC, LWPOLYLINE and
// two-dimensional POLYLINE, and closed bodies of SOLID, TRACE and CIRCLE. A part is a layer.
// Colours: of the entity (420, then 62), of its layer, of its INSERT (BYBLOCK). Layers' and blocks'
// names are equal whatever their case. What is on a layer that is off or frozen, invisible (60) or
// in paper space (67) is left out and counted in a warning; what is not read (3DSOLID, LINE, TEXT,
// polylines with a width, ...), in another, by kind. Throws MeshError.
ColouredMesh parse_dxf(std::string_view file);

}  // namespace aspect
