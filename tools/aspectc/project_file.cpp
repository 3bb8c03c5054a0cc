#include "tools/aspectc/project_file.h"

#include <fmt/format.h>

#include "runtime/service/segmentation_table.h"
#include "runtime/service/table_reader.h"

namespace aspect {

Result<Project> read_project(const std::filesystem::path& file, const VisionParameters& vision) {
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(file, unreadable))
    return Error{file.string() + ": cannot be read; check the path"};
  toml::table root;
  try {
    root = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    return Error{fmt::format("{}:{}: {}; see aspectc --help", file.string(),
                             error.source().begin.line, error.description())};
  }
  TableReader reader(root, file.string(), "");
  std::optional<std::string> scene;
  reader.read("scene", scene);
  reader.require("scene");
  const toml::table* segmentation = reader.table("segmentation");
  if (auto error = reader.finish()) return *error;
  Project project;
  project.vision = vision;
  project.scene = file.parent_path() / *scene;
  if (segmentation != nullptr)
    if (auto error = read_segmentation(*segmentation, file.string(), project.vision)) return *error;
  project.vision.region_of_interest = {};
  return project;
}

}  // namespace aspect
