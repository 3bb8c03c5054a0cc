#include "tools/calibrate/commands/camera_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "runtime/capture/recorded_frames.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/calibrate/camera/board_draw.h"
#include "tools/calibrate/camera/camera_fit.h"
#include "tools/calibrate/commands/command_end.h"
#include "tools/calibrate/output/debug_pictures.h"
#include "tools/calibrate/output/table_edit.h"
#include "tools/draw/frame_canvas.h"
#include "tools/replay/console.h"

namespace aspect {
namespace {

constexpr const char* kCameraNotes =
    R"(Take 10 to 20 pictures with the lens, focus and size of picture that the camera will have:
focus locked (focus_automatic_continuous = 0), the board as large as a third of the picture and
more, near each of the picture's corners in some, and tilted by 20 to 40 degrees to all sides. A
checkerboard must be seen as a whole. Move the board or the camera, and hold still. Of videos,
frames that show the board where it was already are passed over.

-o writes [camera] into FILE.toml, for --config of every program; what else the file says stays.
Without it, the table is printed.

Keys of --json:
  camera       width, height, fx, fy, cx, cy, k1, k2, p1, p2, k3
  errors       fx, fy, cx, cy: standard deviations, in pixels
  residual_px  root mean square of how far corners are from where the camera would show them
  covered      share of the picture that corners cover
  pictures     picture, corners, residual_px; 0 corners: no board found
  alike        frames passed over
  warnings     as on standard error

Examples:
  aspect-calibrate camera --square-mm 25 board_pictures/ -o camera.toml
  aspect-calibrate camera --kind charuco --squares 9x7 --square-mm 27 --dump seen turned.avi)";

constexpr std::size_t kMostPictures = 400;

struct ReadBoards {
  std::vector<BoardPicture> found;
  std::vector<std::size_t> numbers;  // of the pictures found, in all
  std::vector<cv::Mat> kept;         // of the same, where they are to be drawn
  std::vector<std::string> not_found;
  cv::Size size;
  std::size_t alike = 0;
};

// In both, and moved by less than a part of the picture: says what is known already.
bool is_alike(const SeenBoard& a, const SeenBoard& b, cv::Size size) {
  constexpr double kMoved = 0.01;
  if (a.numbers != b.numbers) return false;
  double sum = 0;
  for (std::size_t k = 0; k < a.points.size(); ++k) sum += cv::norm(a.points[k] - b.points[k]);
  return sum / static_cast<double>(a.points.size()) < kMoved * size.width;
}

cv::Mat grey_of(const cv::Mat& picture) {
  cv::Mat grey;
  if (picture.channels() == 1) return picture;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

Result<Done> read_board(const CapturedFrame& frame, const Board& board, const DebugPictures& debug,
                        ReadBoards& boards) {
  const cv::Mat picture = picture_of(frame.view());
  if (boards.size.empty()) boards.size = picture.size();
  if (picture.size() != boards.size)
    return Error{
        fmt::format("{}: {} x {} px, others {} x {}; a camera is calibrated for one size: leave it "
                    "out, or turn "
                    "it like the others",
                    frame.name, picture.cols, picture.rows, boards.size.width, boards.size.height)};
  BoardPicture found{frame.name, find_board(grey_of(picture), board)};
  if (found.seen.empty()) {
    boards.not_found.push_back(frame.name);
    return debug.wanted()
               ? debug.write(frame.sequence, "corners", draw_board(picture, {}, board, nullptr))
               : Result<Done>(Done{});
  }
  for (const BoardPicture& other : boards.found)
    if (is_alike(found.seen, other.seen, boards.size)) {
      ++boards.alike;
      return Done{};
    }
  if (boards.found.size() == kMostPictures)
    return Error{fmt::format("{}: more than {} pictures of the board; fewer say as much",
                             frame.name, kMostPictures)};
  boards.found.push_back(std::move(found));
  boards.numbers.push_back(frame.sequence);
  if (debug.wanted()) boards.kept.push_back(picture);
  return Done{};
}

Result<ReadBoards> read_boards(const CameraCommand& command, const Board& board,
                               const DebugPictures& debug) {
  const std::vector<std::filesystem::path> paths(command.pictures.begin(), command.pictures.end());
  RecordedFrames frames(paths);
  Console console(kCalibrateProgram);
  CapturedFrame frame;
  ReadBoards boards;
  for (FrameStatus status; (status = frames.next(frame)) != FrameStatus::end;) {
    if (status == FrameStatus::failed) return Error{frame.error};
    console.progress(frame.sequence + 1, frames.count(), frame.name);
    if (auto done = read_board(frame, board, debug, boards); !done) return Error{done.error()};
  }
  return boards;
}

std::vector<KeyValue> camera_values(const CameraFit& fit) {
  const CameraModel& m = fit.model;
  std::vector<KeyValue> values = {{"width", fmt::to_string(fit.width_px)},
                                  {"height", fmt::to_string(fit.height_px)}};
  for (const auto& [key, value] : {std::pair{"fx", m.fx_px}, std::pair{"fy", m.fy_px},
                                   std::pair{"cx", m.cx_px}, std::pair{"cy", m.cy_px}})
    values.push_back({key, fmt::format("{:.4f}", value)});
  for (const auto& [key, value] :
       {std::pair{"k1", m.k1}, std::pair{"k2", m.k2}, std::pair{"p1", m.p1}, std::pair{"p2", m.p2},
        std::pair{"k3", m.k3}})
    values.push_back({key, fmt::format("{:.8f}", value)});
  return values;
}

std::string report_of(const CameraFit& fit) {
  return fmt::format(
      "{} pictures, corners off by {:.3f} px, {:.0f} % of the picture covered\n"
      "fx {:.2f} +- {:.2f}, fy {:.2f} +- {:.2f}, centre {:.2f} +- {:.2f}, {:.2f} +- {:.2f} px{}\n",
      fit.pictures.size(), fit.residual_px, 100 * fit.covered_share, fit.model.fx_px,
      fit.fx_error_px, fit.model.fy_px, fit.fy_error_px, fit.model.cx_px, fit.cx_error_px,
      fit.model.cy_px, fit.cy_error_px, fit.has_k3 ? "" : "; k3 is not known from 0 and left so");
}

std::string commented(const std::string& report) {
  std::string text;
  for (std::size_t begin = 0; begin < report.size();) {
    const std::size_t end = report.find('\n', begin);
    text += "# " + report.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return text;
}

std::string json_of(const CameraFit& fit, const ReadBoards& boards,
                    const std::vector<std::string>& warnings) {
  const CameraModel& m = fit.model;
  nlohmann::ordered_json json{{"camera",
                               {{"width", fit.width_px},
                                {"height", fit.height_px},
                                {"fx", m.fx_px},
                                {"fy", m.fy_px},
                                {"cx", m.cx_px},
                                {"cy", m.cy_px},
                                {"k1", m.k1},
                                {"k2", m.k2},
                                {"p1", m.p1},
                                {"p2", m.p2},
                                {"k3", m.k3}}},
                              {"errors",
                               {{"fx", fit.fx_error_px},
                                {"fy", fit.fy_error_px},
                                {"cx", fit.cx_error_px},
                                {"cy", fit.cy_error_px}}},
                              {"residual_px", fit.residual_px},
                              {"covered", fit.covered_share},
                              {"pictures", nlohmann::ordered_json::array()},
                              {"alike", boards.alike},
                              {"warnings", warnings}};
  for (std::size_t k = 0; k < boards.found.size(); ++k)
    json["pictures"].push_back({{"picture", boards.found[k].name},
                                {"corners", boards.found[k].seen.numbers.size()},
                                {"residual_px", fit.pictures[k].residual_px}});
  for (const std::string& name : boards.not_found)
    json["pictures"].push_back({{"picture", name}, {"corners", 0}, {"residual_px", nullptr}});
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<Done> draw_all(const ReadBoards& boards, const Board& board, const CameraFit& fit,
                      const DebugPictures& debug) {
  for (std::size_t k = 0; k < boards.kept.size(); ++k)
    if (auto done =
            debug.write(boards.numbers[k], "corners",
                        draw_board(boards.kept[k], boards.found[k].seen, board, &fit.pictures[k]));
        !done)
      return done;
  return debug.write(0, "coverage", draw_coverage(boards.found, fit));
}

std::vector<std::string> all_warnings(const ReadBoards& boards, const CameraFit& fit) {
  std::vector<std::string> warnings;
  if (!boards.not_found.empty())
    warnings.push_back(
        fmt::format("no board is found in {} of {} pictures: {}{}", boards.not_found.size(),
                    boards.not_found.size() + boards.found.size() + boards.alike,
                    boards.not_found.front(), boards.not_found.size() > 1 ? " and others" : ""));
  for (std::string& warning : fit_warnings(fit, boards.found))
    warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace

CLI::App* add_camera_command(CLI::App& app, CameraCommand& command) {
  CLI::App* camera = app.add_subcommand(
      "camera", "Measure focal lengths, principal point and lens from pictures of a board.");
  camera->add_option("pictures", command.pictures, "pictures of the board, folders of them, videos")
      ->required()
      ->type_name("FRAME");
  camera->add_option("-o,--output", command.output, "file that [camera] goes into")
      ->type_name("FILE.toml");
  camera->add_flag("--json", command.json, "print one JSON object");
  camera->add_option("--dump", command.dump, "write pictures of the corners found and what is left")
      ->type_name("FOLDER");
  add_board_words(*camera, command.board);
  camera->footer(kCameraNotes);
  return camera;
}

int run_camera(const CameraCommand& command) {
  const Result<Board> board = board_of(command.board);
  if (!board) return end_misused(board.error());
  const auto debug = DebugPictures::create(
      command.dump.empty() ? std::nullopt : std::optional<std::filesystem::path>(command.dump));
  if (!debug) return end_failed(debug.error());
  if (!command.output.empty())
    if (auto done = check_writable(command.output); !done) return end_failed(done.error());
  Result<ReadBoards> boards = read_boards(command, board.value(), debug.value());
  if (!boards) return end_failed(boards.error());
  const Result<CameraFit> fit =
      fit_camera(boards.value().found, board.value(), boards.value().size);
  if (!fit)
    return end_failed(fmt::format("{}: {}; is it a board of {}?", command.pictures.front(),
                                  fit.error(), words_of(board.value())));
  const std::vector<std::string> warnings = all_warnings(boards.value(), fit.value());
  warn_all(warnings);
  if (debug.value().wanted())
    if (auto done = draw_all(boards.value(), board.value(), fit.value(), debug.value()); !done)
      return end_failed(done.error());
  const std::string report = report_of(fit.value());
  const std::vector<KeyValue> values = camera_values(fit.value());
  if (!command.output.empty())
    if (auto done = put_values(command.output, commented(report), "camera", values); !done)
      return end_failed(done.error());
  if (command.json)
    fmt::print("{}", json_of(fit.value(), boards.value(), warnings));
  else if (command.output.empty())
    fmt::print("{}", with_values(commented(report), "camera", values));
  else
    fmt::print("{}{}: [camera] written\n", report, command.output);
  return 0;
}

}  // namespace aspect
