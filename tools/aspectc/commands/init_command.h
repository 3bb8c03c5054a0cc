// aspectc init SCENE: writes a commented project.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace aspect {

struct InitCommand {
  std::string scene, output;
};

CLI::App* add_init_command(CLI::App& app, InitCommand& command);
int run_init(const InitCommand& command);

}  // namespace aspect
