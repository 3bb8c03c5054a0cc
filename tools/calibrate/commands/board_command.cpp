#include "tools/calibrate/commands/board_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "tools/aspectc/commands/whole_file.h"
#include "tools/calibrate/board/board_page.h"
#include "tools/calibrate/commands/command_end.h"

namespace aspect {
namespace {

constexpr const char* kBoardNotes =
    R"(Print at 100 %, not "fit to page", and hold a ruler to the line below the board. Glue the
paper to something flat and stiff: a bent board is the largest error there is. Matt paper shows
no lamps.

Examples:
  aspect-calibrate board -o board.pdf
  aspect-calibrate board --kind charuco --squares 9x7 --square-mm 27 --paper letter -o board.svg)";

}  // namespace

CLI::App* add_board_command(CLI::App& app, BoardCommand& command) {
  CLI::App* board = app.add_subcommand("board", "Write a board to print, true to scale.");
  board->add_option("-o,--output", command.output, "what to write")
      ->required()
      ->type_name("FILE.pdf|FILE.svg");
  take_words(
      board->add_option("--paper", command.paper, "upright or lying, as the board fits [a4]"),
      {"a4", "letter"});
  add_board_words(*board, command.board);
  board->footer(kBoardNotes);
  return board;
}

int run_board(const BoardCommand& command) {
  const Result<Board> board = board_of(command.board);
  if (!board) return end_misused(board.error());
  const std::string ending = std::filesystem::path(command.output).extension().native();
  if (ending != ".pdf" && ending != ".svg")
    return end_misused(command.output + ": boards are written as .pdf or .svg; name it so");
  const Paper paper = command.paper == "letter" ? kLetter : kA4;
  const Result<std::string> text =
      ending == ".pdf" ? board_pdf(board.value(), paper) : board_svg(board.value(), paper);
  if (!text) return end_failed(text.error());
  if (const auto done = write_whole_text(command.output, text.value()); !done)
    return end_failed(done.error());
  fmt::print("{}: print at 100 %; then: aspect-calibrate camera {} PICTURES\n", command.output,
             words_of(board.value()));
  return 0;
}

}  // namespace aspect
