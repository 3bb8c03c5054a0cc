// What can be mended without knowing what was meant.
#pragma once

#include <optional>
#include <string>

#include "tools/aspectc/project/prepared_object.h"
#include "tools/doctor/colour_moves.h"
#include "tools/doctor/face_set.h"
#include "tools/doctor/topology_checks.h"

namespace aspect {

struct Repair {
  Scene scene;
  std::optional<ColouredMesh> mesh;  // in the file's coordinates; where a mesh file was read
  std::vector<std::string> done;     // a line each
  std::vector<ColourMove> moves;
};

// Faces without area and repeated ones removed, vertices welded, faces turned outwards, the object
// centred and, where no working distance is given, scaled to fit, and colours that touch moved
// apart. Lamps keep their place about the object. Open edges stay open.
// Fails where the file cannot be read again.
Result<Repair> repair(const PreparedObject& object);

// The mesh without its faults.
ColouredMesh repaired_mesh(const ColouredMesh& mesh, const FaceSet& set, const Topology& topology);

// Text PLY with a colour a face.
std::string ply_text(const ColouredMesh& mesh);

}  // namespace aspect
