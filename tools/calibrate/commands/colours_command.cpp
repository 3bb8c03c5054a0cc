#include "tools/calibrate/commands/colours_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/capture/recorded_frames.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/calibrate/colours/project_colours.h"
#include "tools/calibrate/colours/sample_draw.h"
#include "tools/calibrate/colours/surface_colours.h"
#include "tools/calibrate/commands/command_end.h"
#include "tools/calibrate/light/capture_locks.h"
#include "tools/calibrate/object/posed_frames.h"
#include "tools/calibrate/output/debug_pictures.h"
#include "tools/draw/frame_canvas.h"

namespace aspect {
namespace {

constexpr const char* kColoursNotes =
    R"(A designer's colours differ from what a camera sees by up to 0.15 in the shares of red,
green and blue, those of one setting by 0.01 to 0.05. So: lock white balance, exposure and gain;
take three to ten frames in which the object, compiled in the colours that it has, is found, each
surface in one at least; and compile it again in the colours that are written:
  aspectc part.b -o part.aspect
  aspect-calibrate colours --scene part.b --index part.aspect --config cam.toml frames -o part.toml
  aspectc part.toml -o part.aspect

-o writes a project: of a scene a new one; of a project the same one (it may be the same file) with
[[surface]] tables at its end. Without it they are printed.

Where the object is not found, point at its surfaces: --click SURFACE,X,Y or --click
SURFACE,X,Y,FRAME, with the surface's number from 0 as in [[surface]] index, a pixel of it, and the
frame's number from 0 among those given. Surfaces of one colour are one.

Keys of --json:
  colours   surfaces, before, share (r, g, b), estimated (not seen: by the light on the others),
            spread (between frames), brightness (0 to 255), frames, pixels; share null: not known
  frames    frame, found, probability, reprojection_px, light_change (of the ratio of two channels
            against all frames; 1: none)
  warnings  as on standard error)";

struct Click {
  int surface = 0, x = 0, y = 0;
  std::size_t frame = 0;
};

struct Measured {
  std::vector<PaintSample> samples;
  std::vector<std::string> names;  // of frames, which samples name by place
  std::vector<std::size_t> numbers;
  std::vector<cv::Mat> pictures, maps;  // of the same; maps may be empty
  std::vector<double> probabilities, reprojections_px;
  std::vector<std::string> warnings, not_found;
};

std::optional<Click> click_of(const std::string& words) {
  std::vector<int> numbers;
  const char* at = words.data();
  const char* end = at + words.size();
  for (;;) {
    int number = 0;
    const auto parsed = std::from_chars(at, end, number);
    if (parsed.ec != std::errc() || number < 0) return std::nullopt;
    numbers.push_back(number);
    if (parsed.ptr == end) break;
    if (*parsed.ptr != ',') return std::nullopt;
    at = parsed.ptr + 1;
  }
  if (numbers.size() != 3 && numbers.size() != 4) return std::nullopt;
  return Click{numbers[0], numbers[1], numbers[2],
               numbers.size() == 4 ? static_cast<std::size_t>(numbers[3]) : 0};
}

SamplingParameters sampling_of(const ColoursCommand& command) {
  SamplingParameters parameters;
  parameters.rim_px = command.rim_px;
  return parameters;
}

std::vector<std::filesystem::path> frame_paths(const ColoursCommand& command) {
  return {command.frames.begin(), command.frames.end()};
}

Result<Measured> measure_by_pose(const ColoursCommand& command, const Scene& scene,
                                 const std::vector<Paint>& paints) {
  const Result<KnownObject> object = known_object(command.index, command.configuration, scene);
  if (!object) return Error{object.error()};
  Result<SurfaceMapper> mapper = SurfaceMapper::create(scene, paints);
  if (!mapper) return Error{mapper.error()};
  const Result<FoundFrames> found = find_object(object.value(), frame_paths(command));
  if (!found) return Error{found.error()};
  Measured measured;
  measured.not_found = found.value().not_found;
  if (found.value().posed.empty())
    return Error{fmt::format(
        "{}: {} is found in none of {} frames; look at them with aspect-replay --overlay, or point "
        "at its surfaces with --click",
        command.frames.front(), scene.name, found.value().names.size())};
  for (const PosedFrame& frame : found.value().posed) {
    const cv::Mat map = mapper.value().paints(frame);
    SamplingParameters sampling = sampling_of(command);
    sampling.rim_px += frame.reprojection_px;
    for (PaintSample& sample :
         sample_paints(frame.picture, map, paints.size(), measured.names.size(), sampling))
      measured.samples.push_back(std::move(sample));
    measured.names.push_back(frame.name);
    measured.numbers.push_back(frame.number);
    measured.pictures.push_back(frame.picture);
    measured.maps.push_back(map);
    measured.probabilities.push_back(frame.probability);
    measured.reprojections_px.push_back(frame.reprojection_px);
  }
  measured.warnings = lock_warnings(found.value().pictures, found.value().names);
  return measured;
}

Result<Measured> measure_clicks(const ColoursCommand& command, const Scene& scene,
                                const std::vector<Paint>& paints) {
  const std::vector<int> by_surface = paint_by_surface(scene, paints);
  RecordedFrames frames(frame_paths(command));
  Measured measured;
  CapturedFrame frame;
  for (FrameStatus status; (status = frames.next(frame)) != FrameStatus::end;) {
    if (status == FrameStatus::failed) return Error{frame.error};
    measured.names.push_back(frame.name);
    measured.numbers.push_back(frame.sequence);
    measured.pictures.push_back(picture_of(frame.view()));
    measured.maps.emplace_back();
    measured.probabilities.push_back(0);
    measured.reprojections_px.push_back(0);
  }
  for (const std::string& words : command.clicks) {
    const Click click = *click_of(words);
    if (click.frame >= measured.names.size())
      return Error{
          fmt::format("--click {}: there are frames 0 to {}", words, measured.names.size() - 1)};
    const auto surface = static_cast<std::size_t>(click.surface);
    if (surface >= by_surface.size() || by_surface[surface] < 0)
      return Error{
          fmt::format("--click {}: the scene has surfaces 0 to {}", words, by_surface.size() - 1)};
    auto sample = sample_at(measured.pictures[click.frame], {click.x, click.y}, by_surface[surface],
                            click.frame, sampling_of(command));
    if (!sample)
      return Error{
          fmt::format("--click {}: no surface's colour in {} there: outside of the picture, too "
                      "dark, or cut off at 255",
                      words, measured.names[click.frame])};
    measured.samples.push_back(std::move(*sample));
  }
  return measured;
}

std::string surfaces_text(const Paint& paint) {
  return fmt::format("{} {}", paint.surfaces.size() > 1 ? "surfaces" : "surface",
                     fmt::join(paint.surfaces, ", "));
}

// Under a light that changes, that colours differ between frames is no news.
bool tells_of_white_balance(const std::vector<std::string>& warnings) {
  return std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("white_balance") != std::string::npos;
  });
}

// Numbers of all surfaces of the paints that the question is answered with yes for; empty: of none.
template <typename Question>
std::string surfaces_where(const std::vector<Paint>& paints, Question&& is_one) {
  Paint all;
  for (std::size_t p = 0; p < paints.size(); ++p)
    if (is_one(p))
      all.surfaces.insert(all.surfaces.end(), paints[p].surfaces.begin(), paints[p].surfaces.end());
  std::sort(all.surfaces.begin(), all.surfaces.end());
  return all.surfaces.empty() ? std::string() : surfaces_text(all);
}

void add_colour_warnings(const std::vector<Paint>& paints, const std::vector<PaintColour>& colours,
                         int chroma_step, std::vector<std::string>& warnings) {
  constexpr double kCutOff = 0.2, kUneven = 0.03;
  const bool light_changes = tells_of_white_balance(warnings);
  const auto add = [&](const std::string& surfaces, const std::string& what) {
    if (!surfaces.empty()) warnings.push_back(surfaces + ": " + what);
  };
  add(surfaces_where(paints, [&](std::size_t p) { return paints[p].textured; }),
      "a texture is left as it is");
  add(surfaces_where(paints, [&](std::size_t p) { return colours[p].is_estimate; }),
      "not seen well enough in any frame, and estimated by the light on the others; show them, "
      "lighter "
      "or nearer");
  add(surfaces_where(paints,
                     [&](std::size_t p) {
                       return colours[p].frames == 0 && !colours[p].is_estimate &&
                              !paints[p].textured && !paints[p].is_background;
                     }),
      "not seen well enough in any frame, and left as it is; show it, lighter or nearer");
  add(surfaces_where(paints, [&](std::size_t p) { return colours[p].cut_off_share > kCutOff; }),
      "many pixels are cut off at 255; lower exposure_time_absolute or gain");
  if (!light_changes)
    add(surfaces_where(paints, [&](std::size_t p) { return colours[p].spread > kUneven; }),
        "shares differ by more than 0.03 between frames; light of two colours, or highlights");
  for (std::size_t p = 0; p < paints.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      if (colours[p].frames > 0 && colours[q].frames > 0 &&
          255 * (colours[p].share - colours[q].share).cwiseAbs().maxCoeff() < chroma_step)
        warnings.push_back(
            surfaces_text(paints[q]) + " and " + surfaces_text(paints[p]) +
            ": have one colour under this light, and will be one region where they meet");
}

void add_light_warning(const Measured& measured, const std::vector<double>& changes,
                       std::vector<std::string>& warnings) {
  constexpr double kChanged = 1.12;
  const auto most = std::max_element(changes.begin(), changes.end());
  if (most == changes.end() || *most < kChanged) return;
  if (tells_of_white_balance(warnings)) return;
  warnings.push_back(white_balance_warning(
      *most, measured.names[static_cast<std::size_t>(most - changes.begin())], "the others"));
}

nlohmann::ordered_json numbers_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::string colours_json(const Measured& measured, const std::vector<Paint>& paints,
                         const std::vector<PaintColour>& colours,
                         const std::vector<double>& changes,
                         const std::vector<std::string>& warnings) {
  using Json = nlohmann::ordered_json;
  Json json{{"colours", Json::array()}, {"frames", Json::array()}, {"warnings", warnings}};
  for (std::size_t p = 0; p < paints.size(); ++p)
    json["colours"].push_back(
        {{"surfaces", paints[p].surfaces},
         {"before", numbers_of(shares_of(paints[p].shown))},
         {"share", colours[p].frames > 0 || colours[p].is_estimate ? numbers_of(colours[p].share)
                                                                   : Json(nullptr)},
         {"estimated", colours[p].is_estimate},
         {"spread", colours[p].spread},
         {"brightness", colours[p].brightness},
         {"frames", colours[p].frames},
         {"pixels", colours[p].pixels}});
  for (std::size_t k = 0; k < measured.names.size(); ++k)
    json["frames"].push_back({{"frame", measured.names[k]},
                              {"found", true},
                              {"probability", measured.probabilities[k]},
                              {"reprojection_px", measured.reprojections_px[k]},
                              {"light_change", changes[k]}});
  for (const std::string& name : measured.not_found)
    json["frames"].push_back({{"frame", name}, {"found", false}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string colours_text(const std::vector<Paint>& paints,
                         const std::vector<PaintColour>& colours) {
  std::string text = "surfaces      before             measured           +-     frames  pixels\n";
  for (std::size_t p = 0; p < paints.size(); ++p) {
    const Eigen::Vector3d before = shares_of(paints[p].shown);
    const PaintColour& c = colours[p];
    const std::string name = fmt::format("{}", fmt::join(paints[p].surfaces, ","));
    text += fmt::format("{:<12}  {:.3f} {:.3f} {:.3f}  ", name, before.x(), before.y(), before.z());
    text += !c.is_estimate && c.frames == 0
                ? std::string(paints[p].is_background ? "background: too dark\n" : "not seen\n")
            : c.is_estimate
                ? fmt::format("{:.3f} {:.3f} {:.3f}  not seen: by the light on the others\n",
                              c.share.x(), c.share.y(), c.share.z())
                : fmt::format("{:.3f} {:.3f} {:.3f}  {:.3f}  {:>6}  {:>6}\n", c.share.x(),
                              c.share.y(), c.share.z(), c.spread, c.frames, c.pixels);
  }
  return text;
}

Result<Done> draw_measured(const Measured& measured, const std::vector<Paint>& paints,
                           const DebugPictures& debug) {
  for (std::size_t k = 0; k < measured.names.size(); ++k) {
    std::vector<PaintSample> own;
    for (const PaintSample& sample : measured.samples)
      if (sample.frame == k) own.push_back(sample);
    const std::string caption =
        measured.maps[k].empty()
            ? std::string("by clicks")
            : fmt::format("found with {:.2f}, borders off by {:.2f} px", measured.probabilities[k],
                          measured.reprojections_px[k]);
    if (auto done =
            debug.write(measured.numbers[k], "samples",
                        draw_samples(measured.pictures[k], measured.maps[k], paints, own, caption));
        !done)
      return done;
  }
  return Done{};
}

std::string fault_of(const ColoursCommand& command) {
  if (command.index.empty() == command.clicks.empty())
    return "give either --index, to find the object, or --click, to point at its surfaces";
  for (const std::string& words : command.clicks)
    if (!click_of(words)) return "--click " + words + ": give SURFACE,X,Y or SURFACE,X,Y,FRAME";
  if (!command.output.empty() && std::filesystem::path(command.output).extension() != ".toml")
    return command.output + ": a project is written; name it NAME.toml";
  return {};
}

}  // namespace

CLI::App* add_colours_command(CLI::App& app, ColoursCommand& command) {
  CLI::App* colours = app.add_subcommand(
      "colours", "Measure an object's colours as this camera and light show them.");
  colours->add_option("frames", command.frames, "pictures of the object, folders of them, videos")
      ->required()
      ->type_name("FRAME");
  colours
      ->add_option("--scene", command.scene, "the object: a scene, a mesh, or a project with one")
      ->required()
      ->type_name("SCENE|FILE.toml");
  colours->add_option("--index", command.index, "its index, to find it with")
      ->type_name("FILE.aspect");
  colours->add_option("--config", command.configuration, "[camera] and [segmentation]")
      ->type_name("FILE.toml");
  colours->add_option("-o,--output", command.output, "project to write")->type_name("FILE.toml");
  colours->add_option("--click", command.clicks, "a surface and a pixel of it; repeat it for more")
      ->type_name("S,X,Y[,F]")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  colours
      ->add_option("--rim-px", command.rim_px,
                   "pixels along a surface's border that do not count [3]")
      ->check(CLI::Range(0.0, 100.0).description(""))
      ->type_name("N");
  colours->add_flag("--json", command.json, "print one JSON object");
  colours->add_option("--dump", command.dump, "write pictures of what was sampled")
      ->type_name("FOLDER");
  colours->footer(kColoursNotes);
  return colours;
}

int run_colours(const ColoursCommand& command) {
  if (const std::string fault = fault_of(command); !fault.empty()) return end_misused(fault);
  const auto debug = DebugPictures::create(
      command.dump.empty() ? std::nullopt : std::optional<std::filesystem::path>(command.dump));
  if (!debug) return end_failed(debug.error());
  if (!command.output.empty())
    if (auto done = check_writable(command.output); !done) return end_failed(done.error());
  const Result<PreparedObject> object = read_prepared_object(command.scene);
  if (!object) return end_failed(object.error());
  const Scene& scene = object.value().scene;
  const int intensity_min = object.value().settings.options.vision.intensity_min;
  const std::vector<Paint> paints = paints_of(scene, intensity_min);
  Result<Measured> result = command.clicks.empty() ? measure_by_pose(command, scene, paints)
                                                   : measure_clicks(command, scene, paints);
  if (!result) return end_failed(result.error());
  Measured& measured = result.value();
  std::vector<PaintColour> colours = paint_colours(measured.samples, paints.size());
  add_unseen(paints, colours);
  const std::vector<double> changes =
      light_changes(measured.samples, colours, measured.names.size());
  if (!measured.not_found.empty())
    measured.warnings.push_back(fmt::format("not found for certain in {} frames: {}{}",
                                            measured.not_found.size(), measured.not_found.front(),
                                            measured.not_found.size() > 1 ? " and others" : ""));
  add_light_warning(measured, changes, measured.warnings);
  add_colour_warnings(paints, colours, object.value().settings.options.vision.chroma_step,
                      measured.warnings);
  warn_all(measured.warnings);
  if (debug.value().wanted())
    if (auto done = draw_measured(measured, paints, debug.value()); !done)
      return end_failed(done.error());
  const std::string output = command.output.empty() ? "colours.toml" : command.output;
  const Result<std::string> text = project_with_colours(
      command.scene,
      command.output.empty() && command.scene.ends_with(".toml") ? command.scene : output, scene,
      paints, colours);
  if (!text) return end_failed(text.error());
  if (!command.output.empty())
    if (auto done = write_whole_text(command.output, text.value()); !done)
      return end_failed(done.error());
  if (command.json)
    fmt::print("{}", colours_json(measured, paints, colours, changes, measured.warnings));
  else if (command.output.empty())
    fmt::print("{}", text.value());
  else
    fmt::print("{}{}: written; next: aspectc {}\n", colours_text(paints, colours), command.output,
               command.output);
  return 0;
}

}  // namespace aspect
