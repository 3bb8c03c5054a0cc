// A board on paper, true to scale: as vectors, so that no printer driver scales pixels.
#pragma once

#include <string>

#include "runtime/base/result.h"
#include "tools/calibrate/board/board.h"

namespace aspect {

struct Paper {
  double width_mm = 210, height_mm = 297;
};
inline constexpr Paper kA4{210, 297}, kLetter{215.9, 279.4};

// Upright or lying, whichever the board fits on; in its middle, with its name below and a line of
// 100 mm to hold a ruler to. Fails where the board and the rim that printers need do not fit.
Result<std::string> board_svg(const Board& board, const Paper& paper);
Result<std::string> board_pdf(const Board& board, const Paper& paper);

}  // namespace aspect
