// aspect-calibrate board: a board to print.
#pragma once

#include <string>

#include "tools/calibrate/commands/board_words.h"

namespace aspect {

struct BoardCommand {
  BoardWords board;
  std::string paper = "a4", output;
};

CLI::App* add_board_command(CLI::App& app, BoardCommand& command);
int run_board(const BoardCommand& command);

}  // namespace aspect
