// The scene's surface as few flat triangles on a grid, for the device to draw: see
// runtime/recognition/object_model.h.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compiler/scene/scene.h"
#include "schema/class_index_generated.h"

namespace aspect {

// As it lies in the file.
struct PackedModel {
  Eigen::Vector3d least{0, 0, 0}, unit{0, 0, 0};
  double error = 0;  // largest distance between its surface and the scene's
  std::vector<schema::ModelVertex> vertices;
  std::vector<schema::ModelTriangle> triangles;
  std::vector<schema::Paint> paints;
};

// Round surfaces become facets that stray from them by at most kModelError of the scene's diameter.
// Where there are many triangles, as meshes have, they are simplified by as much again, or by more
// where that leaves too many. A textured surface has its plain colour. Empty where the scene has no
// surface, or one that cannot be simplified enough.
inline constexpr double kModelError = 0.003;
PackedModel packed_model(const Scene& scene);

}  // namespace aspect
