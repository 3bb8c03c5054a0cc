// aspect-calibrate colours: an object's own colours as a camera and its light show them.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace aspect {

struct ColoursCommand {
  std::vector<std::string> frames, clicks;
  std::string scene, index, configuration, output, dump;
  double rim_px = 3;
  bool json = false;
};

CLI::App* add_colours_command(CLI::App& app, ColoursCommand& command);
int run_colours(const ColoursCommand& command);

}  // namespace aspect
