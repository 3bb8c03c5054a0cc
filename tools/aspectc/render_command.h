// aspectc render SCENE --from X,Y,Z: one view as a picture, or what is seen in it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace aspect {

struct RenderCommand {
  std::string scene, output;
  std::vector<double> from;
  bool segmented = false;
};

CLI::App* add_render_command(CLI::App& app, RenderCommand& command);
int run_render(const RenderCommand& command);

}  // namespace aspect
