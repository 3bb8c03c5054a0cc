// One coloured cube in every format, made here.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/scene/scene.h"

namespace aspect {

struct CubeFace {
  std::array<Eigen::Vector3d, 4> corners;
  Eigen::Vector3d colour;
  int aci = 0;       // the same in DXF
  std::string name;  // of its material, solid or layer
};

// Of side 20 about kCubeCentre: six faces in colours that every format can say.
inline const Eigen::Vector3d kCubeCentre{3, -5, 7};
const std::vector<CubeFace>& cube_faces();

// The same cube, centred and scaled as meshes are, from a Bob scene.
Scene bob_cube();

struct SampleFile {
  std::string name, bytes;
};

SampleFile cube_ply(const std::string& format, bool colours_of_vertices);
SampleFile cube_off(bool colours_of_vertices);
SampleFile cube_binary_stl(bool magics);
SampleFile cube_text_stl();  // six solids
SampleFile cube_dxf_faces(bool by_layer);
SampleFile cube_dxf_polyface();
SampleFile cube_mtl();
SampleFile cube_obj();  // beside cube_mtl()
SampleFile cube_gltf();
SampleFile cube_glb();

std::string base64(const std::string& bytes);

}  // namespace aspect
