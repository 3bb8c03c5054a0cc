// aspectc models-info INDEX...: sizes and symmetries of objects in the form of BOP's
// models_info.json (Benchmark for 6D Object Pose Estimation, bop_toolkit,
// docs/bop_datasets_format).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/recognition/class_index.h"

namespace CLI {
class App;
}

namespace aspect {

struct ModelsInfoCommand {
  std::vector<std::string> indexes;
  std::string output;
};

CLI::App* add_models_info_command(CLI::App& app, ModelsInfoCommand& command);
int run_models_info(const ModelsInfoCommand& command);

// One object with the ids "1", "2", ... in the order given. Lengths are in the scenes' units.
std::string models_info_json(std::span<const ClassIndex> indexes);

}  // namespace aspect
