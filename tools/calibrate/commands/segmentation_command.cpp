#include "tools/calibrate/commands/segmentation_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/capture/recorded_frames.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/calibrate/commands/command_end.h"
#include "tools/calibrate/light/capture_locks.h"
#include "tools/calibrate/object/posed_frames.h"
#include "tools/calibrate/object/surface_map.h"
#include "tools/calibrate/output/debug_pictures.h"
#include "tools/calibrate/output/table_edit.h"
#include "tools/calibrate/segmentation/segmentation_search.h"
#include "tools/draw/frame_canvas.h"
#include "tools/draw/picture_text.h"
#include "tools/draw/region_draw.h"
#include "tools/replay/console.h"

namespace aspect {
namespace {

constexpr const char* kSegmentationNotes =
    R"(Of every frame in which the object is found, the model at its pose says which regions there
should be. Every second frame is searched for values with which there are; the others decide: values
are proposed where they are better there by more than 0.01 and twice the standard error, and the
object is found as often as before. Give ten frames and more, from several sides, of a calibrated
camera, after its colours (aspect-calibrate colours).

-o puts the values into [segmentation] of FILE.toml, a configuration or a project; what else it says
stays. What is changed for the camera should be changed for the compiler, too.

Keys of --json:
  proposed   whether there are values that are better
  values     of [segmentation], that the search has changed
  searched   frames, score_before, score_after: mean share of surface and region together that both
             have, over surfaces
  held_out   the same of the other frames, gain, gain_error, found_before, found_after
  warnings   as on standard error)";

struct ReadFrame {
  std::string name;
  cv::Mat picture;
  std::optional<PosedFrame> posed;
};

// Where the present values find nothing, others may: what they cannot do is what is looked for.
std::vector<KnownObject> attempts_of(const KnownObject& object) {
  std::vector<KnownObject> attempts{object};
  const VisionParameters& now = object.parameters.vision;
  for (const auto& [chroma, intensity_min, intensity_step] :
       {std::array{now.chroma_step + 5, now.intensity_min, 60}, std::array{6, 30, 20},
        std::array{now.chroma_step, 90, now.intensity_step}}) {
    KnownObject& other = attempts.emplace_back(object);
    other.parameters.vision.chroma_step = chroma;
    other.parameters.vision.intensity_min = intensity_min;
    other.parameters.vision.intensity_step = intensity_step;
  }
  return attempts;
}

Result<std::vector<ReadFrame>> read_posed(const SegmentationCommand& command,
                                          const KnownObject& object) {
  constexpr std::size_t kMost = 200;  // more take minutes and say no more
  const std::vector<std::filesystem::path> paths(command.frames.begin(), command.frames.end());
  RecordedFrames frames(paths);
  Console console(kCalibrateProgram);
  CapturedFrame frame;
  std::vector<ReadFrame> read;
  const std::vector<KnownObject> attempts = attempts_of(object);
  for (FrameStatus status;
       read.size() < kMost && (status = frames.next(frame)) != FrameStatus::end;) {
    if (status == FrameStatus::failed) return Error{frame.error};
    console.progress(frame.sequence + 1, frames.count(), frame.name);
    ReadFrame& one = read.emplace_back();
    one.name = frame.name;
    one.picture = picture_of(frame.view());
    for (const KnownObject& attempt : attempts)
      if (!one.posed) one.posed = find_in_picture(attempt, one.name, one.picture);
  }
  return read;
}

struct SplitFrames {
  std::vector<WantedAreas> searched, held_out;
  std::vector<const ReadFrame*> held_out_frames;
};

SplitFrames split(const std::vector<ReadFrame>& read, SurfaceMapper& mapper) {
  SplitFrames frames;
  bool search = true;
  for (const ReadFrame& frame : read) {
    if (!frame.posed) continue;
    WantedAreas areas = wanted_areas(frame.picture, mapper.paints(*frame.posed));
    if (areas.area_px.empty()) continue;
    (search ? frames.searched : frames.held_out).push_back(std::move(areas));
    if (!search) frames.held_out_frames.push_back(&frame);
    search = !search;
  }
  return frames;
}

int count_found(const KnownObject& object, const std::vector<const ReadFrame*>& frames) {
  int found = 0;
  for (const ReadFrame* frame : frames)
    found += find_in_picture(object, frame->name, frame->picture).has_value();
  return found;
}

// Frame, regions before, regions after.
Result<Done> draw_regions_of(const std::vector<WantedAreas>& frames, const VisionParameters& before,
                             const VisionParameters& after, const DebugPictures& debug) {
  RegionMatch match;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const cv::Mat& picture = frames[k].picture;
    cv::Mat areas, borders;
    frames[k].areas.convertTo(areas, CV_16S);
    cv::compare(distance_to_border(areas), 0.5, borders, cv::CMP_LT);
    std::vector<cv::Mat> parts{picture.clone()};
    parts.front().setTo(cv::Scalar(255, 255, 255), borders);
    for (const VisionParameters& parameters : {before, after}) {
      const double score = match.score(frames[k], parameters);
      cv::Mat drawn = draw_regions(match.regions(), picture.cols, picture.rows);
      drawn.setTo(cv::Scalar(255, 255, 255), borders);
      draw_text(drawn, fmt::format("{} {:.3f}", parts.size() == 1 ? "before" : "after", score),
                {8, 8}, text_style_for(drawn.size()));
      parts.push_back(drawn);
    }
    cv::Mat together;
    cv::hconcat(parts, together);
    if (auto done = debug.write(k, "regions", together); !done) return done;
  }
  return Done{};
}

struct Outcome {
  SearchedValues searched;
  HeldOut held_out;
  std::size_t searched_frames = 0, held_out_frames = 0;
  int found_before = 0, found_after = 0;
  std::vector<std::pair<std::string, int>> values;
  bool proposed = false;
};

std::string segmentation_json(const Outcome& o, const std::vector<std::string>& warnings) {
  using Json = nlohmann::ordered_json;
  Json values = Json::object();
  for (const auto& [key, value] : o.values) values[key] = value;
  return Json{{"proposed", o.proposed},
              {"values", values},
              {"searched",
               {{"frames", o.searched_frames},
                {"score_before", o.searched.score_before},
                {"score_after", o.searched.score_after}}},
              {"held_out",
               {{"frames", o.held_out_frames},
                {"score_before", o.held_out.score_before},
                {"score_after", o.held_out.score_after},
                {"gain", o.held_out.gain},
                {"gain_error", o.held_out.gain_error},
                {"found_before", o.found_before},
                {"found_after", o.found_after}}},
              {"warnings", warnings}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

std::string outcome_text(const Outcome& o) {
  std::string changed;
  for (const auto& [key, value] : o.values)
    changed += fmt::format("{}{} = {}", changed.empty() ? "" : ", ", key, value);
  return fmt::format(
      "searched {} frames: {:.3f} -> {:.3f}{}\nheld out {} frames: {:.3f} -> {:.3f}, gain {:+.3f} "
      "+- {:.3f}; "
      "found {} -> {}\n",
      o.searched_frames, o.searched.score_before, o.searched.score_after,
      changed.empty() ? "" : " with " + changed, o.held_out_frames, o.held_out.score_before,
      o.held_out.score_after, o.held_out.gain, o.held_out.gain_error, o.found_before,
      o.found_after);
}

Outcome decide(const SplitFrames& frames, const KnownObject& object) {
  Outcome outcome;
  const VisionParameters& before = object.parameters.vision;
  outcome.searched_frames = frames.searched.size();
  outcome.held_out_frames = frames.held_out.size();
  outcome.searched = search_values(frames.searched, before);
  const VisionParameters& after = outcome.searched.parameters;
  outcome.values = changed_values(before, after);
  outcome.held_out = compare_values(frames.held_out, before, after);
  outcome.found_before = count_found(object, frames.held_out_frames);
  KnownObject changed = object;
  changed.parameters.vision = after;
  outcome.found_after = count_found(changed, frames.held_out_frames);
  outcome.proposed = !outcome.values.empty() && outcome.held_out.is_better &&
                     outcome.found_after >= outcome.found_before;
  return outcome;
}

Result<Done> print_outcome(const SegmentationCommand& command, const Outcome& outcome,
                           const std::vector<std::string>& warnings) {
  std::vector<KeyValue> values;
  for (const auto& [key, value] : outcome.values) values.push_back({key, fmt::to_string(value)});
  const std::string text = outcome_text(outcome);
  if (outcome.proposed && !command.output.empty()) {
    const std::string head = fmt::format(
        "# searched by aspect-calibrate segmentation: surfaces and regions "
        "share {:.3f}, not {:.3f}\n",
        outcome.held_out.score_after, outcome.held_out.score_before);
    if (auto done = put_values(command.output, head, "segmentation", values); !done) return done;
  }
  if (command.json) {
    fmt::print("{}", segmentation_json(outcome, warnings));
  } else {
    fmt::print("{}", text);
    if (!outcome.proposed)
      fmt::print("nothing is proposed: the present values do as well on frames not searched on\n");
    else if (command.output.empty())
      fmt::print("\n{}", with_values("", "segmentation", values));
    else
      fmt::print("{}: [segmentation] written\n", command.output);
  }
  return Done{};
}

}  // namespace

CLI::App* add_segmentation_command(CLI::App& app, SegmentationCommand& command) {
  CLI::App* segmentation = app.add_subcommand(
      "segmentation", "Search values of [segmentation] for a camera, from frames of an object.");
  segmentation
      ->add_option("frames", command.frames, "pictures of the object, folders of them, videos")
      ->required()
      ->type_name("FRAME");
  segmentation
      ->add_option("--scene", command.scene, "the object: a scene, a mesh, or a project with one")
      ->required()
      ->type_name("SCENE|FILE.toml");
  segmentation->add_option("--index", command.index, "its index, to find it with")
      ->required()
      ->type_name("FILE.aspect");
  segmentation
      ->add_option("--config", command.configuration, "[camera], and [segmentation] to start from")
      ->type_name("FILE.toml");
  segmentation->add_option("-o,--output", command.output, "file that [segmentation] goes into")
      ->type_name("FILE.toml");
  segmentation->add_flag("--json", command.json, "print one JSON object");
  segmentation->add_option("--dump", command.dump, "write pictures of the regions before and after")
      ->type_name("FOLDER");
  segmentation->footer(kSegmentationNotes);
  return segmentation;
}

int run_segmentation(const SegmentationCommand& command) {
  const auto debug = DebugPictures::create(
      command.dump.empty() ? std::nullopt : std::optional<std::filesystem::path>(command.dump));
  if (!debug) return end_failed(debug.error());
  if (!command.output.empty())
    if (auto done = check_writable(command.output); !done) return end_failed(done.error());
  const Result<Scene> scene = read_prepared_scene(command.scene);
  if (!scene) return end_failed(scene.error());
  const Result<KnownObject> object =
      known_object(command.index, command.configuration, scene.value());
  if (!object) return end_failed(object.error());
  Result<SurfaceMapper> mapper = SurfaceMapper::create(
      scene.value(), paints_of(scene.value(), object.value().indexes.front().vision.intensity_min));
  if (!mapper) return end_failed(mapper.error());
  const Result<std::vector<ReadFrame>> read = read_posed(command, object.value());
  if (!read) return end_failed(read.error());
  const SplitFrames frames = split(read.value(), mapper.value());
  constexpr std::size_t kLeastHeldOut = 3, kFewHeldOut = 5;
  if (frames.held_out.size() < kLeastHeldOut)
    return end_failed(
        fmt::format("{}: {} is found in {} of {} frames; give six or more in which it is: three to "
                    "search on, three "
                    "to decide",
                    command.frames.front(), scene.value().name,
                    frames.searched.size() + frames.held_out.size(), read.value().size()));
  std::vector<cv::Mat> pictures;
  std::vector<std::string> names, warnings;
  for (const ReadFrame& frame : read.value()) {
    pictures.push_back(frame.picture);
    names.push_back(frame.name);
  }
  warnings = lock_warnings(pictures, names);
  if (frames.held_out.size() < kFewHeldOut)
    warnings.push_back(
        fmt::format("{} frames to decide on are few; small gains are not told from chance",
                    frames.held_out.size()));
  warn_all(warnings);
  const Outcome outcome = decide(frames, object.value());
  if (debug.value().wanted())
    if (auto done = draw_regions_of(frames.held_out, object.value().parameters.vision,
                                    outcome.searched.parameters, debug.value());
        !done)
      return end_failed(done.error());
  const Result<Done> done = print_outcome(command, outcome, warnings);
  return done ? 0 : end_failed(done.error());
}

}  // namespace aspect
