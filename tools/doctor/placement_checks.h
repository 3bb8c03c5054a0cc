// Faults of size and place.
#pragma once

#include <optional>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/scene.h"
#include "tools/doctor/finding.h"

namespace aspect {

struct WorkingDistance {
  double near = 1, far = 1;
  bool given = false;  // by a project: the scene is then in units of its own
};

// The radius about studio.at that lies in the picture at the near distance.
double radius_that_fits(const Studio& studio, const WorkingDistance& distance);

// Off the point that the camera looks at; out of the picture; lost in it.
std::vector<Finding> check_place(const Scene& scene, const WorkingDistance& distance);

// Whether the size in the file is that of a thing that can stand before a camera, and in which
// unit: glTF means metres, the other formats say nothing.
std::vector<Finding> check_unit(const ColouredMesh& mesh, bool in_metres);

}  // namespace aspect
