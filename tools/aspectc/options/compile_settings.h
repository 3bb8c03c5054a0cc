// All that a compile project can say about one object, besides which scene it is. What is absent
// stays as the scene has it.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/aspects/compile_options.h"
#include "compiler/scene/step_mesh.h"

namespace aspect {

// [camera]. Either the field of view or the focal lengths; pixel centres are at whole numbers.
struct StudioCameraSettings {
  std::optional<int> width_px, height_px;
  std::optional<double> field_of_view_deg;
  std::optional<double> fx_px, fy_px, cx_px, cy_px;
  // Nearest and farthest distance of the camera from the point that it looks at, in scene units.
  std::optional<std::vector<double>> distance;
};

// [[light.point]]
struct LampSettings {
  Eigen::Vector3d position{0, 0, 0};
  Eigen::Vector3d colour{1, 1, 1};
  bool shadows = true;
};

// [light]
struct LightSettings {
  std::optional<std::vector<double>> ambient;  // r g b
  std::vector<LampSettings> lamps;             // where there are any, instead of the scene's
};

// [[surface]]: every surface that it means, by place in Scene::surfaces or by diffuse colour, gets
// new colours.
struct SurfaceSettings {
  std::string place;  // FILE:LINE
  std::optional<int> index;
  std::optional<Eigen::Vector3d> colour;
  std::optional<Eigen::Vector3d> diffuse, ambient;
};

// [mesh]
struct MeshSettings {
  std::optional<int> merge_colours;
  // Instead of the file's: by the name of a part or of its material (of a STEP file: of a face, of
  // a body), or by the part's number from "0".
  std::map<std::string, Eigen::Vector3d> colours;
  double chord_error = kDefaultChordError;            // of STEP files
  std::optional<std::vector<double>> missing_colour;  // r g b; of Bob scenes too
};

struct CompileSettings {
  CompileOptions options;
  StudioCameraSettings camera;
  LightSettings light;
  std::vector<SurfaceSettings> surfaces;
  MeshSettings mesh;
  bool combined = false;    // all objects of the project in one file
  std::optional<int> jobs;  // threads; one a core
};

}  // namespace aspect
