// Boards that a camera is calibrated with: what they look like and where their corners are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/recognition/camera_model.h"

namespace aspect {

// A checkerboard, or one with a marker of OpenCV's ArUco in each white square (Garrido-Jurado et
// al., Automatic generation and detection of highly reliable fiducial markers, 2014), which may be
// seen in part. Coordinates are in mm from the pattern's upper left corner, x right, y down, as the
// board is read; the square there is black.
struct Board {
  enum class Kind : std::uint8_t { checkerboard, charuco } kind = Kind::checkerboard;
  int columns = 10, rows = 7;  // squares
  double square_mm = 25;
  // Of ChArUco boards only.
  double marker_mm = 18;
  int marker_side = 4;  // bits along a side: 4, 5 or 6

  int corner_columns() const { return columns - 1; }
  int corner_rows() const { return rows - 1; }
  int corners() const { return corner_columns() * corner_rows(); }
  // Corners are numbered row by row.
  Point2d corner_mm(int number) const {
    return {(number % corner_columns() + 1) * square_mm,
            (number / corner_columns() + 1) * square_mm};
  }
  bool is_black(int column, int row) const { return (column + row) % 2 == 0; }
};

// Squares, markers and their number within what can be printed, seen and told apart.
Result<Board> checked_board(const Board& board);

struct BlackBox {
  double x_mm = 0, y_mm = 0, width_mm = 0, height_mm = 0;
};

// All that is black; boxes may touch but not overlap.
std::vector<BlackBox> black_boxes(const Board& board);

// The options of `aspect-calibrate` that name this board.
std::string words_of(const Board& board);

}  // namespace aspect
