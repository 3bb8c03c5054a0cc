#include "tools/aspectc/project/prepared_object.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/scene/scene_reader.h"
#include "tools/aspectc/options/option_text.h"
#include "tools/aspectc/options/settings_check.h"
#include "tools/aspectc/project/scene_settings.h"

namespace aspect {
namespace {

Result<Project> project_of(const std::filesystem::path& file) {
  if (file.extension() == ".toml") return read_project(file);
  return Project{{{file, "", {}}}, false};
}

}  // namespace

std::variant<PlannedObjects, PreparationError> plan_objects(const std::filesystem::path& file,
                                                            std::span<const GivenFlag> flags) {
  Result<Project> project = project_of(file);
  if (!project) return PreparationError{project.error()};
  PlannedObjects planned;
  planned.is_list = project.value().has_list;
  for (ProjectObject& object : project.value().objects) {
    for (const GivenFlag& flag : flags) flag.option->set(object.settings, flag.value);
    if (const auto fault = find_fault(object.settings, flag_name))
      return PreparationError{fault->what, true};
    if (object.name.empty()) object.name = object.scene.stem().string();
    for (const ProjectObject& other : planned.objects)
      if (other.name == object.name)
        return PreparationError{
            fmt::format("{}: two objects are called {}; give one of them another name",
                        file.native(), object.name)};
    planned.combined = object.settings.combined;
    CompileOptions& options = object.settings.options;
    options.min_level = std::min(options.min_level, options.level);
    options.jobs = object.settings.jobs.value_or(0);
    planned.objects.push_back(std::move(object));
  }
  return planned;
}

MeshColours mesh_colours(const MeshSettings& mesh) {
  MeshColours colours;
  colours.by_name = mesh.colours;
  if (mesh.merge_colours) colours.merged = static_cast<std::size_t>(*mesh.merge_colours);
  if (mesh.missing_colour) colours.missing = Eigen::Vector3d(mesh.missing_colour->data());
  return colours;
}

Result<PreparedObject> prepare_object(const ProjectObject& object, const StandIn& stand_in) {
  if (object.settings.mesh.merge_colours && lower_extension(object.scene) == ".b")
    return Error{object.scene.native() +
                 ": is a Bob scene, and colours are merged of meshes alone; leave merge_colours "
                 "out, or name its surfaces' colours with [[surface]]"};
  SceneReading reading{{}, mesh_colours(object.settings.mesh)};
  if (!reading.colours.missing) reading.colours.missing = stand_in;
  reading.chord_error = object.settings.mesh.chord_error;
  Result<Scene> scene = read_scene(object.scene, reading);
  if (!scene) return Error{scene.error()};
  PreparedObject prepared{object.scene, std::move(scene).value(), object.settings};
  prepared.scene.name = object.name;
  if (auto done = apply_settings(object.settings, prepared.scene); !done)
    return Error{done.error()};
  return prepared;
}

std::variant<std::vector<PreparedObject>, PreparationError> prepare_objects(
    const std::filesystem::path& file, std::span<const GivenFlag> flags, const StandIn& stand_in) {
  const auto planned = plan_objects(file, flags);
  if (const auto* error = std::get_if<PreparationError>(&planned)) return *error;
  std::vector<PreparedObject> prepared;
  for (const ProjectObject& object : std::get<PlannedObjects>(planned).objects) {
    Result<PreparedObject> one = prepare_object(object, stand_in);
    if (!one) return PreparationError{one.error()};
    prepared.push_back(std::move(one).value());
  }
  return prepared;
}

Result<PreparedObject> read_prepared_object(const std::filesystem::path& file,
                                            const StandIn& stand_in) {
  auto prepared = prepare_objects(file, {}, stand_in);
  if (const auto* error = std::get_if<PreparationError>(&prepared)) return Error{error->message};
  auto& objects = std::get<std::vector<PreparedObject>>(prepared);
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
