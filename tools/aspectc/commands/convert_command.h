// aspectc convert IN OUT.b: any scene as a Bob scene.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace aspect {

struct ConvertCommand {
  std::string scene, output;
  std::vector<double> missing_colour;  // none: an error
};

CLI::App* add_convert_command(CLI::App& app, ConvertCommand& command);
int run_convert(const ConvertCommand& command);

}  // namespace aspect
