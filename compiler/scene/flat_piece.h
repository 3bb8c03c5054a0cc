// Pieces of a mesh that are one flat polygon.
#pragma once

#include <optional>

#include "compiler/scene/scene.h"

namespace aspect {

// The polygon that covers exactly what the mesh does: where all of it lies in one plane, to 1e-7 of
// its size, and its border is one closed line that touches itself nowhere. Nothing otherwise, and
// where the border has more than 1000 corners.
std::optional<Polygon> as_polygon(const Mesh& mesh);

}  // namespace aspect
