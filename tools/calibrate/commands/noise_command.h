// aspect-calibrate noise: how noisy a camera is, and what that means for segmentation.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace aspect {

struct NoiseCommand {
  std::vector<std::string> frames;
  std::string configuration, output, dump;
  bool json = false;
};

CLI::App* add_noise_command(CLI::App& app, NoiseCommand& command);
int run_noise(const NoiseCommand& command);

}  // namespace aspect
