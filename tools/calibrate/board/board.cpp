#include "tools/calibrate/board/board.h"

#include <fmt/format.h>

#include <cmath>

#include "tools/calibrate/board/markers.h"

namespace aspect {
namespace {

void add_square(const Board& board, int column, int row, std::vector<BlackBox>& boxes) {
  boxes.push_back(
      {column * board.square_mm, row * board.square_mm, board.square_mm, board.square_mm});
}

// Black bits of a row that touch each other are one box, so that no printer draws a line between.
void add_marker(const Board& board, const PlacedMarker& marker, std::vector<BlackBox>& boxes) {
  const int cells = board.marker_side + 2;  // a black rim of one
  const double cell = board.marker_mm / cells;
  const double left = (marker.column + 0.5) * board.square_mm - board.marker_mm / 2;
  const double top = (marker.row + 0.5) * board.square_mm - board.marker_mm / 2;
  for (int y = 0; y < cells; ++y) {
    int begin = 0;
    for (int x = 0; x <= cells; ++x) {
      const bool is_black = x < cells && !is_white_cell(board.marker_side, marker.number, x, y);
      if (is_black) continue;
      if (x > begin)
        boxes.push_back({left + begin * cell, top + y * cell, (x - begin) * cell, cell});
      begin = x + 1;
    }
  }
}

}  // namespace

Result<Board> checked_board(const Board& board) {
  constexpr int kLeast = 3, kMost = 60;
  constexpr double kLeast_mm = 1, kMost_mm = 1000;
  if (board.columns < kLeast || board.rows < kLeast || board.columns > kMost || board.rows > kMost)
    return Error{fmt::format("a board of {} x {} squares; give {} to {} along each side",
                             board.columns, board.rows, kLeast, kMost)};
  if (!(board.square_mm >= kLeast_mm && board.square_mm <= kMost_mm))
    return Error{
        fmt::format("squares of {} mm; give {} to {}", board.square_mm, kLeast_mm, kMost_mm)};
  if (board.kind == Board::Kind::checkerboard) return board;
  if (board.marker_side < 4 || board.marker_side > 6)
    return Error{"markers have 4, 5 or 6 bits along a side"};
  if (!(board.marker_mm > 0.3 * board.square_mm && board.marker_mm < 0.95 * board.square_mm))
    return Error{fmt::format("markers of {} mm in squares of {} mm; give 0.3 to 0.95 of a square",
                             board.marker_mm, board.square_mm)};
  if (board.columns * board.rows / 2 > kMarkers)
    return Error{fmt::format("a board with {} markers; there are {} different ones: fewer squares",
                             board.columns * board.rows / 2, kMarkers)};
  return board;
}

std::vector<BlackBox> black_boxes(const Board& board) {
  std::vector<BlackBox> boxes;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column)
      if (board.is_black(column, row)) add_square(board, column, row, boxes);
  if (board.kind == Board::Kind::charuco)
    for (const PlacedMarker& marker : markers_of(board)) add_marker(board, marker, boxes);
  return boxes;
}

std::string words_of(const Board& board) {
  const std::string size =
      fmt::format("--squares {}x{} --square-mm {}", board.columns, board.rows, board.square_mm);
  if (board.kind == Board::Kind::checkerboard) return size;
  return fmt::format("--kind charuco {} --marker-mm {} --marker-bits {}", size, board.marker_mm,
                     board.marker_side);
}

}  // namespace aspect
