#include "tools/calibrate/calibrate_program.h"

#include <CLI/CLI.hpp>

#include "tools/calibrate/commands/board_command.h"
#include "tools/calibrate/commands/camera_command.h"
#include "tools/calibrate/commands/colours_command.h"
#include "tools/calibrate/commands/command_end.h"
#include "tools/calibrate/commands/noise_command.h"
#include "tools/calibrate/commands/segmentation_command.h"

namespace aspect {
namespace {

constexpr const char* kNotes = R"(In this order:
  aspect-calibrate board -o board.pdf               print it, glue it to something flat
  aspect-calibrate camera PICTURES -o camera.toml   pictures of the board
  aspect-calibrate noise FRAMES -o camera.toml      two frames or more of a scene at rest
  aspect-calibrate colours --scene part.b --index part.aspect --config camera.toml FRAMES
                           -o part.toml
  aspectc part.toml -o part.aspect                  in the colours that the camera sees
  aspect-calibrate segmentation --scene part.toml --index part.aspect --config camera.toml FRAMES
                                -o camera.toml
Each command has its own --help.)";

}  // namespace

int run_calibrate(int argc, const char* const* argv) {
  CLI::App app("Measures a camera and its light for the other programs.", kCalibrateProgram);
  app.set_version_flag("--version", "aspect-calibrate " ASPECT_VERSION);
  BoardCommand board_command;
  CLI::App* board = add_board_command(app, board_command);
  CameraCommand camera_command;
  CLI::App* camera = add_camera_command(app, camera_command);
  ColoursCommand colours_command;
  CLI::App* colours = add_colours_command(app, colours_command);
  NoiseCommand noise_command;
  CLI::App* noise = add_noise_command(app, noise_command);
  SegmentationCommand segmentation_command;
  CLI::App* segmentation = add_segmentation_command(app, segmentation_command);
  // Last: a command would take it over.
  app.footer(kNotes);
  if (const auto exit_code = parse_command_line(app, argc, argv)) return *exit_code;
  if (board->parsed()) return run_board(board_command);
  if (camera->parsed()) return run_camera(camera_command);
  if (colours->parsed()) return run_colours(colours_command);
  if (noise->parsed()) return run_noise(noise_command);
  if (segmentation->parsed()) return run_segmentation(segmentation_command);
  return end_misused("no command given; aspect-calibrate --help shows them");
}

}  // namespace aspect
