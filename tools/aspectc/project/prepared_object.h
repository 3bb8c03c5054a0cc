// From what a command line names to what the compiler takes.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/scene/mesh_scene.h"
#include "compiler/scene/scene.h"
#include "runtime/base/result.h"
#include "tools/aspectc/options/compile_settings.h"
#include "tools/aspectc/options/option_flags.h"
#include "tools/aspectc/project/project_file.h"

namespace aspect {

// What a command line names, before any scene is read.
struct PlannedObjects {
  std::vector<ProjectObject> objects;  // each with a name of its own, the flags in its settings
  bool is_list = false;                // of a project with [[object]]
  bool combined = false;
};

struct PreparedObject {
  std::filesystem::path scene_file;
  Scene scene;  // with all settings applied; its warnings are for the user
  CompileSettings settings;
};

// A colour for those that are not found; without one they are errors.
using StandIn = std::optional<Eigen::Vector3d>;

struct PreparationError {
  std::string message;
  bool usage = false;
};

// Of a scene, or of all that a project (.toml) names; flags win over the project. Contradicting
// flags are a fault of usage and told apart.
std::variant<PlannedObjects, PreparationError> plan_objects(const std::filesystem::path& file,
                                                            std::span<const GivenFlag> flags);

// Reads the scene. `stand_in` stands for colours that are not found where no option says one.
Result<PreparedObject> prepare_object(const ProjectObject& object, const StandIn& stand_in = {});

// Both in one.
std::variant<std::vector<PreparedObject>, PreparationError> prepare_objects(
    const std::filesystem::path& file, std::span<const GivenFlag> flags,
    const StandIn& stand_in = {});

// A scene file, or a project with a single object, for programs that render it.
Result<PreparedObject> read_prepared_object(const std::filesystem::path& file,
                                            const StandIn& stand_in = {});
Result<Scene> read_prepared_scene(const std::filesystem::path& file, const StandIn& stand_in = {});

// The colours that the settings say for the file's own.
MeshColours mesh_colours(const MeshSettings& mesh);

}  // namespace aspect
