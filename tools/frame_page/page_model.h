// An index's model as the page draws it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "runtime/recognition/class_index.h"

namespace aspect {

// {"object", "classes": how many, "fov": degrees, "centre", "up", "radius", "unit", "vertices":
// [x, y, z, ...] from the centre in units, "triangles": [corner, corner, corner, colour, ...],
// "edges": [end, end, corner beside it, corner on the other side, 1 where it is smooth, ...], "colours": ["#rrggbb"], the first for what is too dark to tell,
// "surfaces": {"number": "name"}}. Without vertices: the index has no model.
nlohmann::json model_json(const ClassIndex& index);

}  // namespace aspect
