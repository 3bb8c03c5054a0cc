// Every kind of scene file, by its extension.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compiler/scene/mesh_scene.h"
#include "compiler/scene/scene.h"
#include "compiler/scene/step_mesh.h"
#include "runtime/base/result.h"

namespace aspect {

struct SceneReading {
  std::vector<std::filesystem::path> include_path;  // of Bob scenes
  MeshColours colours;  // of meshes; the one for missing colours of Bob scenes too
  double chord_error = kDefaultChordError;  // of STEP files
};

// A Bob scene (.b) or a mesh (.obj .ply .stl .gltf .glb .dxf .off .3ds .3mf .step .stp, in any
// case). Errors are one line that names the file; for another extension it lists these.
Result<Scene> read_scene(const std::filesystem::path& file, const SceneReading& reading = {});

// ".obj" of "A.OBJ".
std::string lower_extension(const std::filesystem::path& file);

}  // namespace aspect
