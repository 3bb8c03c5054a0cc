#include "tools/aspectc/project/project_file.h"

#include <fmt/format.h>
#include <algorithm>
#include <fstream>

#include "tools/aspectc/options/option_text.h"
#include "tools/aspectc/options/settings_check.h"
#include "tools/aspectc/project/project_tables.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxFileBytes = 1U << 20U;

// Files are named after objects.
bool is_name(std::string_view text) {
  constexpr std::size_t kMost = 64;
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  };
  return !text.empty() && text.size() <= kMost && text.front() != '.' && text.front() != '-' &&
         std::all_of(text.begin(), text.end(), fits);
}

struct ObjectKeys {
  std::optional<std::string> scene, name;
};

ObjectKeys read_object_keys(TableReader& reader) {
  ObjectKeys keys;
  reader.read("scene", keys.scene);
  reader.read("name", keys.name);
  if (keys.name && !is_name(*keys.name))
    reader.fail("name", "is no name; use up to 64 letters, digits and _ - .");
  if (keys.scene && (keys.scene->empty() || keys.scene->find('\0') != std::string::npos))
    reader.fail("scene", "is no file; name the scene");
  return keys;
}

std::optional<Error> check(const CompileSettings& settings, const ProjectTables& tables,
                           const fs::path& file, std::uint32_t line) {
  const auto fault = find_fault(settings, key_name);
  if (!fault) return std::nullopt;
  for (const Option* option : fault->options) {
    const std::uint32_t own_line = tables.line_of(option->text.table, option->text.key);
    if (own_line == 0) continue;
    line = own_line;
    break;
  }
  return Error{fmt::format("{}:{}: {}", file.native(), line, fault->what)};
}

Result<ProjectObject> read_object(const toml::table& table, const fs::path& file,
                                  const CompileSettings& common) {
  TableReader reader(table, file.native(), "object");
  const ObjectKeys keys = read_object_keys(reader);
  reader.require("scene");
  const ProjectTables tables(reader, file.native(), "object.");
  if (auto error = reader.finish()) return *error;
  ProjectObject object{file.parent_path() / *keys.scene, keys.name.value_or(""), common};
  if (auto error = tables.read(object.settings)) return *error;
  if (auto error = check(object.settings, tables, file, table.source().begin.line)) return *error;
  return object;
}

Result<Project> read_root(const toml::table& root, const fs::path& file) {
  TableReader reader(root, file.native(), "");
  const ObjectKeys keys = read_object_keys(reader);
  const auto objects = reader.tables("object");
  const ProjectTables tables(reader, file.native(), "");
  if (objects.empty())
    reader.require("scene");
  else if (keys.scene || keys.name)
    reader.fail(keys.scene ? "scene" : "name", "and [[object]] are given; leave one of them out");
  if (objects.size() > kMaxProjectObjects)
    reader.fail("object", fmt::format("is there more than {} times; make two projects of it",
                                      kMaxProjectObjects));
  if (auto error = reader.finish()) return *error;
  CompileSettings common;
  if (auto error = tables.read(common)) return *error;
  Project project;
  project.has_list = !objects.empty();
  for (const toml::table* table : objects) {
    Result<ProjectObject> object = read_object(*table, file, common);
    if (!object) return Error{object.error()};
    project.objects.push_back(std::move(object).value());
  }
  if (project.has_list) return project;
  if (auto error = check(common, tables, file, 1)) return *error;
  project.objects.push_back(
      {file.parent_path() / *keys.scene, keys.name.value_or(""), std::move(common)});
  return project;
}

}  // namespace

Result<Project> read_project(const fs::path& file) {
  std::error_code unreadable;
  if (!fs::is_regular_file(file, unreadable))
    return Error{file.native() + ": cannot be read; check the path"};
  if (fs::file_size(file, unreadable) > kMaxFileBytes || unreadable)
    return Error{file.native() + ": too large for a project; it has at most 1 MiB"};
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) return Error{file.native() + ": cannot be read; check its permissions"};
  return parse_project(text, file);
}

Result<Project> parse_project(std::string_view text, const fs::path& file) {
  try {
    return read_root(toml::parse(text, file.native()), file);
  } catch (const toml::parse_error& error) {
    return Error{fmt::format("{}:{}: not TOML: {}; mend the line", file.native(),
                             error.source().begin.line, error.description())};
  }
}

}  // namespace aspect
