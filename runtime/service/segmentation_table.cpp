#include "runtime/service/segmentation_table.h"

#include <array>

#include "runtime/service/segmentation_values.h"
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

void read_value(TableReader& reader, const SegmentationValue& value, std::optional<int>& member) {
  reader.read(value.key, {static_cast<int>(value.least), static_cast<int>(value.most)}, member);
}
void read_value(TableReader& reader, const SegmentationValue& value, std::optional<float>& member) {
  reader.read(value.key, {value.least, value.most}, member);
}
void read_value(TableReader& reader, const SegmentationValue& value, std::optional<bool>& member) {
  reader.read(value.key, member);
}

}  // namespace

std::optional<Error> read_segmentation(const toml::table& table, const std::string& file,
                                       SegmentationOverrides& overrides) {
  TableReader reader(table, file, "segmentation");
  for (const SegmentationValue& value : segmentation_values())
    std::visit([&](auto member) { read_value(reader, value, overrides.*member); }, value.member);
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
