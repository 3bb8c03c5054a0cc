#include "runtime/service/segmentation_table.h"

#include <array>

#include "runtime/service/table_reader.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

void read_region_of_interest(TableReader& reader, std::optional<Box>& box) {
  constexpr std::string_view kKey = "region_of_interest";
  std::optional<std::array<int, 4>> edges;
  reader.read(kKey, {0, kMaxFrameSide_px}, edges);
  if (!edges) return;
  const auto [x, y, width, height] = *edges;
  if (width == 0 || height == 0)
    return reader.fail(kKey, "is empty; give [x, y, width, height] in pixels, or leave it out");
  box = Box{x, y, width, height};
}

}  // namespace

std::optional<Error> read_segmentation(const toml::table& table, const std::string& file,
                                       SegmentationOverrides& overrides) {
  constexpr int kMaxPixels = kMaxFrameSide_px * kMaxFrameSide_px;
  TableReader reader(table, file, "segmentation");
  reader.read("intensity_min", {0, 765}, overrides.intensity_min);
  reader.read("chroma_step", {1, 255}, overrides.chroma_step);
  reader.read("noise_steps", {0, 255}, overrides.noise_steps);
  reader.read("intensity_step", {0, 765}, overrides.intensity_step);
  reader.read("area_min_px", {1, kMaxPixels}, overrides.area_min_px);
  reader.read("thickness_min_px", {0, kMaxFrameSide_px}, overrides.thickness_min_px);
  reader.read("smooth", overrides.smooth);
  reader.read("one_blob", overrides.one_blob);
  reader.read("range_step_length", {1e-9, 1e9}, overrides.range_step_length);
  reader.read("range_steps_min", {1, 65534}, overrides.range_steps_min);
  reader.read("range_steps_max", {1, 65534}, overrides.range_steps_max);
  reader.read("range_depth_step", {1e-5, 1}, overrides.range_depth_step);
  reader.read("range_normal_step_deg", {1, 90}, overrides.range_normal_step_deg);
  read_region_of_interest(reader, overrides.region_of_interest);
  return reader.finish();
}

std::optional<Error> read_segmentation(const toml::table& table, const std::string& file,
                                       VisionParameters& parameters) {
  SegmentationOverrides overrides;
  if (auto error = read_segmentation(table, file, overrides)) return error;
  overrides.apply(parameters);
  return std::nullopt;
}

}  // namespace aspect
