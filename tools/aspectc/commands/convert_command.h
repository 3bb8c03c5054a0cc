// aspectc convert IN OUT.b: any scene as a Bob scene.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace aspect {

struct ConvertCommand {
  std::string scene, output;
};

CLI::App* add_convert_command(CLI::App& app, ConvertCommand& command);
int run_convert(const ConvertCommand& command);

}  // namespace aspect
