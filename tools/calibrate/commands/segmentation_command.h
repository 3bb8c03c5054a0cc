// aspect-calibrate segmentation: values of [segmentation] for a camera and an object.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace aspect {

struct SegmentationCommand {
  std::vector<std::string> frames;
  std::string scene, index, configuration, output, dump;
  bool json = false;
};

CLI::App* add_segmentation_command(CLI::App& app, SegmentationCommand& command);
int run_segmentation(const SegmentationCommand& command);

}  // namespace aspect
