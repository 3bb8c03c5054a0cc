#include "runtime/service/configuration.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>

#include "runtime/base/input_file.h"
#include "runtime/base/portable_math.h"
#include "runtime/service/output_table.h"
#include "runtime/service/segmentation_table.h"
#include "runtime/service/table_reader.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxFileBytes = 1U << 20U;

template <typename Value>
void replace(Value& value, const std::optional<Value>& by) {
  if (by) value = *by;
}

void read_capture(TableReader& reader, CameraSettings& capture) {
  constexpr int kLeastStall_ms = 100, kMostStall_ms = 60'000;
  constexpr double kLeastRate_hz = 0.01, kMostRate_hz = 1000;
  std::optional<std::string> device, format;
  std::optional<int> stall_ms;
  reader.read("device", device);
  reader.read("format", format);
  reader.read("rate", {kLeastRate_hz, kMostRate_hz}, capture.rate_hz);
  reader.read("stall_ms", {kLeastStall_ms, kMostStall_ms}, stall_ms);
  std::vector<std::pair<std::string, std::int64_t>> controls;
  reader.read("controls", controls);
  for (auto& [name, value] : controls) capture.controls.push_back({std::move(name), value});
  if (device && device->empty()) reader.fail("device", "is empty; name a camera, as /dev/video0");
  if (format && format->size() != 4)
    reader.fail("format", "must have four characters, as YUYV; leave it out to let aspectd choose");
  if (device) capture.device = std::move(*device);
  if (format) capture.format = std::move(*format);
  if (stall_ms) capture.stall = std::chrono::milliseconds(*stall_ms);
}

std::optional<Error> read_camera(const toml::table& table, const std::string& file,
                                 Configuration& configuration) {
  // Far beyond any lens; it keeps the arithmetic of projections from overflowing.
  constexpr double kMost_px = 1e6, kLeastFocal_px = 1;
  constexpr std::array<std::string_view, 6> kLens = {"width", "height", "fx", "fy", "cx", "cy"};
  CameraSettings& capture = configuration.capture;
  std::optional<int> width, height;
  std::optional<double> fx, fy, cx, cy;
  TableReader reader(table, file, "camera");
  reader.read("width", {1, kMaxFrameSide_px}, width);
  reader.read("height", {1, kMaxFrameSide_px}, height);
  reader.read("fx", {kLeastFocal_px, kMost_px}, fx);
  reader.read("fy", {kLeastFocal_px, kMost_px}, fy);
  reader.read("cx", {-kMost_px, kMost_px}, cx);
  reader.read("cy", {-kMost_px, kMost_px}, cy);
  std::optional<double> k1, k2, p1, p2, k3;
  const std::array bends{std::pair{"k1", &k1}, std::pair{"k2", &k2}, std::pair{"p1", &p1},
                         std::pair{"p2", &p2}, std::pair{"k3", &k3}};
  constexpr double kMostBend = 1e3;
  for (const auto& [key, value] : bends) reader.read(key, {-kMostBend, kMostBend}, *value);
  const bool bent = k1 || k2 || p1 || p2 || k3;
  read_capture(reader, capture);
  if (fx || fy || cx || cy || bent)
    for (const std::string_view key : kLens) reader.require(key);
  if (width && !height) reader.require("height");
  if (height && !width) reader.require("width");
  if (auto error = reader.finish()) return error;
  if (width) capture.width_px = *width;
  if (height) capture.height_px = *height;
  if (!fx) return std::nullopt;
  const CameraModel model{
      *fx,           *fy, *cx, *cy, k1.value_or(0), k2.value_or(0), p1.value_or(0), p2.value_or(0),
      k3.value_or(0)};
  if (!is_sound(model, *width, *height))
    return Error{file +
                 ": [camera] k1, k2, p1, p2, k3 fold the picture, so that one pixel shows two "
                 "directions; calibrate again with views that reach the corners, or leave k3 out"};
  configuration.camera = CameraConfiguration{*width, *height, model};
  return std::nullopt;
}

std::optional<Error> read_recognition(const toml::table& table, const std::string& file,
                                      RecognitionOverrides& overrides) {
  using Ranking = RecogniserParameters::Ranking;
  constexpr std::array<std::string_view, 2> kMatchings = {"simple", "weighted"};
  constexpr std::array<std::string_view, 2> kRankings = {"views", "classes"};
  std::optional<std::size_t> matching, ranking;
  TableReader reader(table, file, "recognition");
  reader.read("matching", kMatchings, matching);
  reader.read("ranking", kRankings, ranking);
  reader.read("top", {1, kMaxHypotheses}, overrides.top);
  reader.read("shortlist_slack", {0, kMaxBlobContours}, overrides.shortlist_slack);
  reader.read("score_min", {0, 1e12}, overrides.score_min);
  reader.read("min_confidence", {0, 1}, overrides.confidence_min);
  reader.read("anywhere", overrides.anywhere);
  reader.read("track", overrides.track);
  reader.read("search_every", {1, kMostSearchEvery}, overrides.search_every);
  reader.read("time_limit_ms", {kLeastTimeLimit_ms, kMostTimeLimit_ms}, overrides.time_limit_ms);
  if (matching) overrides.matching = *matching == 0 ? Matching::simple : Matching::weighted;
  if (ranking) overrides.ranking = *ranking == 0 ? Ranking::views : Ranking::classes;
  return reader.finish();
}

std::optional<Error> read_process(const toml::table& table, const std::string& file,
                                  ProcessSettings& process) {
  constexpr int kMostCpus = 1024;
  std::optional<bool> lock_memory;
  std::optional<int> realtime_priority;
  TableReader reader(table, file, "process");
  reader.read("lock_memory", lock_memory);
  reader.read("realtime_priority", {0, 99}, realtime_priority);
  reader.read("cpus", {0, kMostCpus - 1}, process.cpus);
  replace(process.lock_memory, lock_memory);
  replace(process.realtime_priority, realtime_priority);
  return reader.finish();
}

Result<Configuration> read_tables(const toml::table& root, const std::string& file) {
  Configuration configuration;
  std::optional<std::vector<std::string>> indexes;
  TableReader reader(root, file, "");
  reader.read("indexes", indexes);
  const toml::table* camera = reader.table("camera");
  const toml::table* segmentation = reader.table("segmentation");
  const toml::table* recognition = reader.table("recognition");
  const toml::table* output = reader.table("output");
  const toml::table* process = reader.table("process");
  if (indexes && std::find(indexes->begin(), indexes->end(), "") != indexes->end())
    reader.fail("indexes", "holds an empty name; give the files of indexes");
  std::optional<Error> error = reader.finish();
  if (camera && !error) error = read_camera(*camera, file, configuration);
  if (segmentation && !error)
    error = read_segmentation(*segmentation, file, configuration.segmentation);
  if (recognition && !error)
    error = read_recognition(*recognition, file, configuration.recognition);
  if (output && !error) error = read_outputs(*output, file, configuration.output);
  if (process && !error) error = read_process(*process, file, configuration.process);
  if (error) return *error;
  if (indexes)
    for (const std::string& index : *indexes)
      configuration.indexes.push_back(fs::path(file).parent_path() / index);
  return configuration;
}

}  // namespace

void SegmentationOverrides::apply(VisionParameters& parameters) const {
  replace(parameters.intensity_min, intensity_min);
  replace(parameters.chroma_step, chroma_step);
  replace(parameters.noise_steps, noise_steps);
  replace(parameters.intensity_step, intensity_step);
  replace(parameters.area_min_px, area_min_px);
  replace(parameters.thickness_min_px, thickness_min_px);
  replace(parameters.smooth, smooth);
  replace(parameters.one_blob, one_blob);
  replace(parameters.region_of_interest, region_of_interest);
  replace(parameters.range.step_length, range_step_length);
  replace(parameters.range.steps_min, range_steps_min);
  replace(parameters.range.steps_max, range_steps_max);
  replace(parameters.range.depth_step, range_depth_step);
  replace(parameters.range.normal_step_deg, range_normal_step_deg);
}

void RecognitionOverrides::apply(RecogniserParameters& parameters) const {
  replace(parameters.matching, matching);
  replace(parameters.ranking, ranking);
  replace(parameters.top, top);
  replace(parameters.shortlist_slack, shortlist_slack);
  replace(parameters.score_min, score_min);
  replace(parameters.confidence_min, confidence_min);
  replace(parameters.anywhere, anywhere);
  replace(parameters.tracking.on, track);
  replace(parameters.tracking.search_every, search_every);
  if (time_limit_ms)
    parameters.time_limit = std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::duration<double, std::milli>(*time_limit_ms));
}

void Configuration::apply(RecogniserParameters& parameters) const {
  segmentation.apply(parameters.vision);
  if (camera) {
    parameters.camera = {camera->model, camera->width_px};
    parameters.vision.range.field_of_view_deg = static_cast<float>(
        2 * portable_atan(camera->width_px / (2 * camera->model.fx_px)) * 180 / std::numbers::pi);
  }
  recognition.apply(parameters);
}

Result<Configuration> read_configuration(const fs::path& file) {
  const std::string& name = file.native();
  InputFile input(file);
  const std::optional<std::uint64_t> bytes = input.size();
  if (input.is_missing()) return Error{name + ": no such file; check the path"};
  if (!bytes) return Error{name + ": " + input.reason() + "; give a TOML file that can be read"};
  if (*bytes > kMaxFileBytes)
    return Error{name + ": too large for a configuration; it has at most 1 MiB"};
  std::string text(static_cast<std::size_t>(*bytes), '\0');
  if (!input.read(std::as_writable_bytes(std::span(text))))
    return Error{name + ": cannot be read to its end; check the disk"};
  return parse_configuration(text, name);
}

Result<Configuration> parse_configuration(std::string_view text, const std::string& name) {
  try {
    return read_tables(toml::parse(text, name), name);
  } catch (const toml::parse_error& error) {
    return Error{fmt::format("{}:{}: not TOML: {}; mend the line", name, error.source().begin.line,
                             error.description())};
  }
}

}  // namespace aspect
