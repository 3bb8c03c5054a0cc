// Faults of faces and of how they are joined.
#pragma once

#include "tools/doctor/face_set.h"
#include "tools/doctor/finding.h"

namespace aspect {

struct Topology {
  std::vector<Finding> findings;
  std::vector<bool> kept;     // by face: false of those without area and of repeated ones
  std::vector<bool> flipped;  // by face: to be turned; never where faces are not wound
};

// Open edges, edges of more than two faces, flipped and repeated faces, faces without area, and
// vertices that are only nearly at one place. Repeated faces and those without area are left out
// before edges are judged.
Topology check_topology(const FaceSet& set);

// Rims of cones and rings that no other rim closes and that stand on no face.
std::vector<Finding> check_rims(const Scene& scene);

}  // namespace aspect
