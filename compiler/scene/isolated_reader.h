// A process of its own for readers that a hostile file may break.
#pragma once

#include <functional>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// What `read` gives, worked out in a child process with at most 8 GiB of memory and 5 minutes of
// processor time: libraries that read meshes and pictures have a record of overruns, and what they
// break must not be this process. Its MeshErrors are thrown here, a crash is one as well.
ColouredMesh read_isolated(const std::function<ColouredMesh()>& read);

}  // namespace aspect
