// NAME.toml: a compile project. It names the scenes and says what is to be done otherwise; `aspectc
// init` writes one with every key.
//   scene = "part.b"          # relative to the project
//   name = "part"             # of the object [the scene's]
//   [subdivision]             # the tables of option_table.h
//   level = 6
//   [[light.point]]           # instead of the scene's lamps: position, colour, shadows
//   [[surface]]               # index = N or colour = [r, g, b]; new diffuse and ambient
//   [mesh]
//   colours = {0 = [1, 0, 0]} # of the parts of a mesh, by number or name
//   merge_colours = 8         # of one that was scanned or shaded
// Instead of the scene, or beside what holds for all objects:
//   [[object]]                # scene, name and any of the tables, as [object.subdivision]
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "tools/aspectc/options/compile_settings.h"

namespace aspect {

struct ProjectObject {
  std::filesystem::path scene;
  std::string name;  // empty: the scene's
  CompileSettings settings;
};

struct Project {
  std::vector<ProjectObject> objects;
  bool has_list = false;  // written as [[object]], even where it is a single one
};

inline constexpr std::size_t kMaxProjectObjects = 64;

// Errors name file and line: unknown keys with the nearest known one, wrong types, numbers out of
// range, options that contradict each other, no scene.
Result<Project> read_project(const std::filesystem::path& file);
Result<Project> parse_project(std::string_view text, const std::filesystem::path& file);

}  // namespace aspect
