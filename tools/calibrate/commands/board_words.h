// The options that say which board it is.
#pragma once

#include <string>

#include "runtime/base/result.h"
#include "tools/calibrate/board/board.h"

namespace CLI {
class App;
}

namespace aspect {

struct BoardWords {
  std::string kind = "checkerboard", squares = "10x7";
  double square_mm = 25, marker_mm = 0;  // 0: 0.72 of a square
  int marker_bits = 4;
};

void add_board_words(CLI::App& command, BoardWords& words);
Result<Board> board_of(const BoardWords& words);

}  // namespace aspect
