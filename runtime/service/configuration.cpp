#include "runtime/service/configuration.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

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

std::optional<Error> read_camera(const toml::table& table, const std::string& file,
                                 std::optional<CameraConfiguration>& camera) {
  // Far beyond any lens; it keeps the arithmetic of projections from overflowing.
  constexpr double kMost_px = 1e6, kLeastFocal_px = 1;
  std::optional<int> width, height;
  std::optional<double> fx, fy, cx, cy;
  TableReader reader(table, file, "camera");
  reader.read("width", {1, kMaxFrameSide_px}, width);
  reader.read("height", {1, kMaxFrameSide_px}, height);
  reader.read("fx", {kLeastFocal_px, kMost_px}, fx);
  reader.read("fy", {kLeastFocal_px, kMost_px}, fy);
  reader.read("cx", {-kMost_px, kMost_px}, cx);
  reader.read("cy", {-kMost_px, kMost_px}, cy);
  for (const std::string_view key : {"width", "height", "fx", "fy", "cx", "cy"})
    reader.require(key);
  if (auto error = reader.finish()) return error;
  camera = CameraConfiguration{*width, *height, *fx, *fy, *cx, *cy};
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
  if (matching) overrides.matching = *matching == 0 ? Matching::simple : Matching::weighted;
  if (ranking) overrides.ranking = *ranking == 0 ? Ranking::views : Ranking::classes;
  return reader.finish();
}

Result<Configuration> read_tables(const toml::table& root, const std::string& file) {
  Configuration configuration;
  TableReader reader(root, file, "");
  const toml::table* camera = reader.table("camera");
  const toml::table* segmentation = reader.table("segmentation");
  const toml::table* recognition = reader.table("recognition");
  if (auto error = reader.finish()) return *error;
  if (camera)
    if (auto error = read_camera(*camera, file, configuration.camera)) return *error;
  if (segmentation)
    if (auto error = read_segmentation(*segmentation, file, configuration.segmentation))
      return *error;
  if (recognition)
    if (auto error = read_recognition(*recognition, file, configuration.recognition)) return *error;
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
}

void Configuration::apply(RecogniserParameters& parameters) const {
  segmentation.apply(parameters.vision);
  if (camera)
    parameters.vision.range.field_of_view_deg = static_cast<float>(
        2 * std::atan(camera->width_px / (2 * camera->fx_px)) * 180 / std::numbers::pi);
  recognition.apply(parameters);
}

Result<Configuration> read_configuration(const fs::path& file) {
  const std::string& name = file.native();
  std::error_code code;
  const fs::file_status status = fs::status(file, code);
  if (!fs::exists(status)) return Error{name + ": no such file; check the path"};
  if (!fs::is_regular_file(status)) return Error{name + ": not a file; give a TOML file"};
  const std::uintmax_t bytes = fs::file_size(file, code);
  if (code || bytes > kMaxFileBytes)
    return Error{name + ": too large for a configuration; it has at most 1 MiB"};
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) return Error{name + ": cannot be read; check its permissions"};
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
