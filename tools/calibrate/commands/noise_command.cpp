#include "tools/calibrate/commands/noise_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/capture/recorded_frames.h"
#include "runtime/service/configuration.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/calibrate/commands/command_end.h"
#include "tools/calibrate/light/capture_locks.h"
#include "tools/calibrate/light/noise_draw.h"
#include "tools/calibrate/light/noise_model.h"
#include "tools/calibrate/output/debug_pictures.h"
#include "tools/calibrate/output/table_edit.h"
#include "tools/draw/frame_canvas.h"

namespace aspect {
namespace {

constexpr const char* kNoiseNotes =
    R"(Best are two to ten frames of anything, of all brightnesses, with camera and scene at rest,
not compressed: what differs between them is noise. Without such a pair flat places within the
frames are measured, which takes fine texture for noise and JPEG's flattening for its absence.

What uses it: [segmentation] noise_steps, which the compiler reads as well as the runtime. It is the
least with which noise parts no surface, from intensity_min up, with the other values of --config;
-o puts it into FILE.toml, a configuration or a project; what else the file says stays.

Keys of --json:
  constant, per_grey  variance of a channel of value v (0 to 255): constant + per_grey * v
  deviation           at 16, 64, 128, 192
  noise_steps         for [segmentation]
  points              value, variance, pixels: what was measured
  pairs               of frames compared; 0: measured within frames
  warnings            as on standard error)";

std::string noise_json(const MeasuredNoise& noise, int steps,
                       const std::vector<std::string>& warnings) {
  using Json = nlohmann::ordered_json;
  const NoiseModel& model = noise.model;
  Json json{
      {"constant", model.constant},
      {"per_grey", model.per_grey},
      {"deviation",
       {model.deviation(16), model.deviation(64), model.deviation(128), model.deviation(192)}},
      {"noise_steps", steps},
      {"points", Json::array()},
      {"pairs", noise.pairs},
      {"warnings", warnings}};
  for (const NoisePoint& p : noise.points)
    json["points"].push_back({{"value", p.value}, {"variance", p.variance}, {"pixels", p.pixels}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

struct NoiseFrames {
  std::vector<cv::Mat> pictures;
  std::vector<std::string> names;
};

Result<NoiseFrames> read_frames(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 32;  // more say no more
  const std::vector<std::filesystem::path> paths(names.begin(), names.end());
  RecordedFrames frames(paths);
  CapturedFrame frame;
  NoiseFrames read;
  for (FrameStatus status;
       read.pictures.size() < kMost && (status = frames.next(frame)) != FrameStatus::end;) {
    if (status == FrameStatus::failed) return Error{frame.error};
    read.pictures.push_back(picture_of(frame.view()));
    read.names.push_back(frame.name);
  }
  if (read.pictures.empty())
    return Error{names.front() + ": holds no frames; name pictures or a video"};
  return read;
}

}  // namespace

CLI::App* add_noise_command(CLI::App& app, NoiseCommand& command) {
  CLI::App* noise = app.add_subcommand("noise", "Measure a camera's noise over brightness.");
  noise->add_option("frames", command.frames, "frames of anything, best of the same several times")
      ->required()
      ->type_name("FRAME");
  noise->add_option("--config", command.configuration, "[segmentation] with the other values")
      ->type_name("FILE.toml");
  noise->add_option("-o,--output", command.output, "file that [segmentation] noise_steps goes into")
      ->type_name("FILE.toml");
  noise->add_flag("--json", command.json, "print one JSON object");
  noise->add_option("--dump", command.dump, "write a picture of the measurement")
      ->type_name("FOLDER");
  noise->footer(kNoiseNotes);
  return noise;
}

int run_noise(const NoiseCommand& command) {
  const auto debug = DebugPictures::create(
      command.dump.empty() ? std::nullopt : std::optional<std::filesystem::path>(command.dump));
  if (!debug) return end_failed(debug.error());
  if (!command.output.empty())
    if (auto done = check_writable(command.output); !done) return end_failed(done.error());
  VisionParameters vision;
  if (!command.configuration.empty()) {
    const Result<Configuration> read = read_configuration(command.configuration);
    if (!read) return end_failed(read.error());
    read.value().segmentation.apply(vision);
  }
  const Result<NoiseFrames> frames = read_frames(command.frames);
  if (!frames) return end_failed(frames.error());
  const Result<MeasuredNoise> noise = measure_noise(frames.value().pictures);
  if (!noise) return end_failed(command.frames.front() + ": " + noise.error());
  std::vector<std::string> warnings = lock_warnings(frames.value().pictures, frames.value().names);
  if (noise.value().pairs == 0)
    warnings.push_back(fmt::format("no two frames show the same: measured within frames{}",
                                   noise.value().is_compressed
                                       ? ", which are compressed, so that there is more noise than "
                                         "is seen; noise_steps is not "
                                         "lowered"
                                       : ""));
  warn_all(warnings);
  const NoiseModel& model = noise.value().model;
  int steps = noise_steps_for(model, vision);
  // Of what compression has flattened nothing can be concluded.
  if (noise.value().is_compressed) steps = std::max(steps, vision.noise_steps);
  const std::string report = fmt::format(
      "variance of a channel of value v: {:.3f} + {:.5f} v; deviation {:.2f} at 16, {:.2f} at "
      "128\n",
      model.constant, model.per_grey, model.deviation(16), model.deviation(128));
  if (auto done = debug.value().write(0, "noise", draw_noise(noise.value())); !done)
    return end_failed(done.error());
  const std::vector<KeyValue> values = {{"noise_steps", fmt::to_string(steps)}};
  if (!command.output.empty())
    if (auto done = put_values(command.output, "# " + report, "segmentation", values); !done)
      return end_failed(done.error());
  if (command.json)
    fmt::print("{}", noise_json(noise.value(), steps, warnings));
  else if (command.output.empty())
    fmt::print("{}", with_values("# " + report, "segmentation", values));
  else
    fmt::print("{}{}: [segmentation] noise_steps = {} written\n", report, command.output, steps);
  return 0;
}

}  // namespace aspect
