#include "tools/aspectc/project/prepared_object.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/scene/scene_reader.h"
#include "tools/aspectc/options/option_text.h"
#include "tools/aspectc/options/settings_check.h"
#include "tools/aspectc/project/project_file.h"
#include "tools/aspectc/project/scene_settings.h"

namespace aspect {
namespace {

Result<Project> project_of(const std::filesystem::path& file) {
  if (file.extension() == ".toml") return read_project(file);
  return Project{{{file, "", {}}}, false};
}

Result<PreparedObject> prepare(const ProjectObject& object, const StandIn& stand_in) {
  SceneReading reading{{}, mesh_colours(object.settings.mesh)};
  if (!reading.colours.missing) reading.colours.missing = stand_in;
  Result<Scene> scene = read_scene(object.scene, reading);
  if (!scene) return Error{scene.error()};
  PreparedObject prepared{object.scene, std::move(scene).value(), object.settings};
  if (!object.name.empty()) prepared.scene.name = object.name;
  if (auto done = apply_settings(object.settings, prepared.scene); !done)
    return Error{done.error()};
  CompileOptions& options = prepared.settings.options;
  options.min_level = std::min(options.min_level, options.level);
  options.jobs = prepared.settings.jobs.value_or(0);
  return prepared;
}

}  // namespace

MeshColours mesh_colours(const MeshSettings& mesh) {
  MeshColours colours;
  for (const auto& [part, colour] : mesh.colours)
    colours.by_name.emplace(std::to_string(part), colour);
  if (mesh.missing_colour) colours.missing = Eigen::Vector3d(mesh.missing_colour->data());
  return colours;
}

std::variant<PreparedObjects, PreparationError> prepare_objects(const std::filesystem::path& file,
                                                                std::span<const GivenFlag> flags,
                                                                const StandIn& stand_in) {
  Result<Project> project = project_of(file);
  if (!project) return PreparationError{project.error()};
  PreparedObjects prepared;
  prepared.is_list = project.value().has_list;
  for (ProjectObject& object : project.value().objects) {
    for (const GivenFlag& flag : flags) flag.option->set(object.settings, flag.value);
    if (const auto fault = find_fault(object.settings, flag_name))
      return PreparationError{fault->what, true};
    Result<PreparedObject> one = prepare(object, stand_in);
    if (!one) return PreparationError{one.error()};
    const std::string& name = one.value().scene.name;
    for (const PreparedObject& other : prepared.objects)
      if (other.scene.name == name)
        return PreparationError{fmt::format(
            "{}: two objects are called {}; give one of them another name", file.native(), name)};
    prepared.combined = one.value().settings.combined;
    prepared.objects.push_back(std::move(one).value());
  }
  return prepared;
}

Result<PreparedObject> read_prepared_object(const std::filesystem::path& file,
                                            const StandIn& stand_in) {
  auto prepared = prepare_objects(file, {}, stand_in);
  if (const auto* error = std::get_if<PreparationError>(&prepared)) return Error{error->message};
  std::vector<PreparedObject>& objects = std::get<PreparedObjects>(prepared).objects;
  if (objects.size() != 1)
    return Error{fmt::format("{}: has {} objects; give a project or a scene with one",
                             file.native(), objects.size())};
  return std::move(objects.front());
}

Result<Scene> read_prepared_scene(const std::filesystem::path& file, const StandIn& stand_in) {
  Result<PreparedObject> object = read_prepared_object(file, stand_in);
  if (!object) return Error{object.error()};
  return std::move(object).value().scene;
}

}  // namespace aspect
