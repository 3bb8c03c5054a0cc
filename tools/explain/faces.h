// The faces of a scene as people see them.
#pragma once

#include "compiler/aspects/colour_separation.h"
#include "compiler/scene/scene.h"
#include "tools/explain/explanation.h"

namespace aspect {

struct Faces {
  std::vector<Face> all;
  std::vector<std::size_t> face_of;  // by surface id of pictures; 0 has none
};

// Polygons of one colour in one plane are a face; every other primitive is one of its own.
Faces faces_of(const Scene& scene);

// The face in another colour, which shows as given where it was seen as `face.colour`.
void paint(Scene& scene, const Face& face, const Eigen::Vector3d& colour);

}  // namespace aspect
