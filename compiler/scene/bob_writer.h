// Writer of Bob scenes.
#pragma once

#include <string>

#include "compiler/scene/scene.h"
#include "runtime/base/result.h"

namespace aspect {

// The scene as one Bob file. Reading it back gives the same pictures: numbers have 17 digits, a
// mesh becomes a polygon a triangle, and triangles that the reader would refuse for want of area
// are left out. Fails where there are more primitives than Bob scenes may have.
Result<std::string> write_bob(const Scene& scene);

}  // namespace aspect
