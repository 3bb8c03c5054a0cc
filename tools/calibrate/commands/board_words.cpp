#include "tools/calibrate/commands/board_words.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>

#include "tools/command_line/command_line.h"

namespace aspect {

void add_board_words(CLI::App& command, BoardWords& words) {
  take_words(command
                 .add_option("--kind", words.kind,
                             "with a marker in each white square (charuco) it may be seen in part "
                             "[checkerboard]")
                 ->group("Board"),
             {"checkerboard", "charuco"});
  command.add_option("--squares", words.squares, "squares across and down, not corners [10x7]")
      ->type_name("CxR")
      ->group("Board");
  command.add_option("--square-mm", words.square_mm, "side of a square [25]")
      ->type_name("MM")
      ->group("Board");
  command.add_option("--marker-mm", words.marker_mm, "side of a marker [0.72 of a square]")
      ->type_name("MM")
      ->group("Board");
  command
      .add_option("--marker-bits", words.marker_bits,
                  "of the markers along a side: OpenCV's DICT_4X4_100, DICT_5X5_100, DICT_6X6_100; "
                  "4, 5 or 6 [4]")
      ->type_name("N")
      ->group("Board");
}

Result<Board> board_of(const BoardWords& words) {
  Board board;
  board.kind = words.kind == "charuco" ? Board::Kind::charuco : Board::Kind::checkerboard;
  const std::string& text = words.squares;
  const char* end = text.data() + text.size();
  const auto across = std::from_chars(text.data(), end, board.columns);
  const bool has_x = across.ec == std::errc() && across.ptr != end && *across.ptr == 'x';
  const auto down = has_x ? std::from_chars(across.ptr + 1, end, board.rows) : across;
  if (!has_x || down.ec != std::errc() || down.ptr != end)
    return Error{"--squares " + text + ": give two numbers, as 10x7"};
  board.square_mm = words.square_mm;
  // To a tenth of a millimetre: people type it again.
  board.marker_mm = words.marker_mm > 0 ? words.marker_mm : std::round(7.2 * words.square_mm) / 10;
  board.marker_side = words.marker_bits;
  return checked_board(board);
}

}  // namespace aspect
