#include "runtime/service/index_set.h"

#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <system_error>

#include "runtime/recognition/index_bundle.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// Which values differ, for people; empty where all are the same.
std::string differences(const VisionParameters& first, const VisionParameters& other) {
  std::string text;
  const auto compare = [&](std::string_view key, auto a, auto b) {
    if (a != b) text += fmt::format("{}{} {} not {}", text.empty() ? "" : ", ", key, b, a);
  };
  compare("intensity_min", first.intensity_min, other.intensity_min);
  compare("chroma_step", first.chroma_step, other.chroma_step);
  compare("noise_steps", first.noise_steps, other.noise_steps);
  compare("intensity_step", first.intensity_step, other.intensity_step);
  compare("area_min_px", first.area_min_px, other.area_min_px);
  compare("thickness_min_px", first.thickness_min_px, other.thickness_min_px);
  compare("smooth", first.smooth, other.smooth);
  if (first.sensor != SensorKind::range) return text;
  compare("range_steps_min", first.range.steps_min, other.range.steps_min);
  compare("range_steps_max", first.range.steps_max, other.range.steps_max);
  compare("range_depth_step", first.range.depth_step, other.range.depth_step);
  compare("range_normal_step_deg", first.range.normal_step_deg, other.range.normal_step_deg);
  return text;
}

bool is_among(const fs::path& file, std::span<const fs::path> others) {
  return std::any_of(others.begin(), others.end(), [&](const fs::path& other) {
    std::error_code code;
    return fs::equivalent(file, other, code);
  });
}

void add_index(const fs::path& file, ClassIndex index, IndexSet& set) {
  const auto same =
      std::find_if(set.indexes.begin(), set.indexes.end(),
                   [&](const ClassIndex& other) { return other.object == index.object; });
  if (same != set.indexes.end()) {
    const auto place = static_cast<std::size_t>(same - set.indexes.begin());
    set.failures.push_back(fmt::format("{}: holds the object {} like {}; leave one of them out",
                                       file.native(), same->object, set.files[place].native()));
    return;
  }
  if (!set.indexes.empty() && set.indexes.front().vision.sensor != index.vision.sensor) {
    set.failures.push_back(
        fmt::format("{}: compiled for frames of a {} sensor, {} of a {} one; one run "
                    "looks at frames of one sensor, leave one of them out",
                    file.native(), name_of(index.vision.sensor), set.files.front().native(),
                    name_of(set.indexes.front().vision.sensor)));
    return;
  }
  const std::string different =
      set.indexes.empty() ? "" : differences(set.indexes.front().vision, index.vision);
  if (!different.empty())
    set.warnings.push_back(
        fmt::format("{}: compiled with another [segmentation] than {}, whose values are "
                    "used: {}",
                    file.native(), set.files.front().native(), different));
  set.indexes.push_back(std::move(index));
  set.files.push_back(file);
}

}  // namespace

void add_indexes(const fs::path& name, std::vector<ClassIndex> indexes, IndexSet& set) {
  for (ClassIndex& index : indexes) add_index(name, std::move(index), set);
}

void load_indexes(const fs::path& file, IndexSet& set) {
  if (is_among(file, set.files)) {
    set.failures.push_back(file.native() + ": given twice; leave one out");
    return;
  }
  Result<std::vector<ClassIndex>> indexes = load_index_file(file);
  if (!indexes) {
    set.failures.push_back(indexes.error());
    return;
  }
  add_indexes(file, std::move(indexes).value(), set);
}

IndexSet load_indexes(std::span<const fs::path> files) {
  IndexSet set;
  for (const fs::path& file : files) load_indexes(file, set);
  return set;
}

}  // namespace aspect
