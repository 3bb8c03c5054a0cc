// aspectc render SCENE --from X,Y,Z: one view as the sensor gives it, or what is seen in
// it. Range and surface frames are pictures of 16 bits.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace aspect {

struct RenderCommand {
  std::string scene, output, sensor;  // no sensor: the project's
  std::vector<double> from;
  bool segmented = false;
};

CLI::App* add_render_command(CLI::App& app, RenderCommand& command);
int run_render(const RenderCommand& command);

}  // namespace aspect
