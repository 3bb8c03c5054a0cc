// aspect-calibrate camera: focal lengths, principal point and lens from pictures of a board.
#pragma once

#include <string>
#include <vector>

#include "tools/calibrate/commands/board_words.h"

namespace aspect {

struct CameraCommand {
  BoardWords board;
  std::vector<std::string> pictures;
  std::string output, dump;
  bool json = false;
};

CLI::App* add_camera_command(CLI::App& app, CameraCommand& command);
int run_camera(const CameraCommand& command);

}  // namespace aspect
