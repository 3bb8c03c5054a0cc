// The tables of a project that hold for one object or for all.
#pragma once

#include <optional>
#include <string>

#include "runtime/service/table_reader.h"
#include "tools/aspectc/options/compile_settings.h"

namespace aspect {

// Asks a reader of the whole project, or of one of its objects, for all tables, so that it knows
// them; then reads them into settings.
class ProjectTables {
 public:
  // `prefix` is what stands before the names of tables: "" or "object.".
  ProjectTables(TableReader& reader, std::string file, std::string prefix);

  // What is absent leaves the settings as they are.
  std::optional<Error> read(CompileSettings& settings) const;

  // Of an option's key, 0 where it is absent.
  std::uint32_t line_of(std::string_view table, std::string_view key) const;

 private:
  struct Named {
    std::string_view name;
    const toml::table* table;
  };
  std::optional<Error> read_table(const Named& named, CompileSettings& settings) const;
  std::optional<Error> read_lamps(const std::vector<const toml::table*>& tables,
                                  LightSettings& light) const;
  std::optional<Error> read_surfaces(CompileSettings& settings) const;
  std::optional<Error> read_part_colours(const toml::table* table, MeshSettings& mesh) const;

  std::string file_, prefix_;
  std::vector<Named> tables_;
  std::vector<const toml::table*> surfaces_;
};

}  // namespace aspect
