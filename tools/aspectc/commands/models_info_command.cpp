#include "tools/aspectc/commands/models_info_command.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/whole_file.h"

namespace aspect {
CLI::App* add_models_info_command(CLI::App& app, ModelsInfoCommand& command) {
  CLI::App* info =
      app.add_subcommand("models-info", "Write sizes and symmetries as BOP's models_info.json.");
  info->add_option("index", command.indexes, "class indexes (.aspect); ids count from 1")
      ->required()
      ->type_name("FILE.aspect");
  info->add_option("-o,--output", command.output, "file to write [standard output]")
      ->type_name("FILE.json");
  info->footer("Examples:\n  aspectc models-info a.aspect b.aspect -o models_info.json");
  return info;
}

int run_models_info(const ModelsInfoCommand& command) {
  std::vector<ClassIndex> indexes;
  for (const std::string& file : command.indexes) {
    Result<ClassIndex> index = load_index(file);
    if (!index) return fail(index.error());
    if (!(index.value().extent.diameter > 0))
      return fail(file + ": does not say how large the object is; compile the scene again");
    indexes.push_back(std::move(index).value());
  }
  const std::string json = models_info_json(indexes);
  if (command.output.empty()) {
    fmt::print("{}", json);
    return 0;
  }
  const Result<Done> done = write_whole_text(command.output, json);
  return done ? 0 : fail(done.error());
}

}  // namespace aspect
