// What the page is told of all that can be set.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/capture/camera_control_list.h"
#include "runtime/recognition/class_index.h"
#include "runtime/workbench/play_control.h"
#include "runtime/workbench/settings_draft.h"

namespace aspect {

// A model's name and the shares of its colours.
struct ModelColours {
  std::string object;
  std::vector<std::array<float, 3>> shares;
};

struct BenchState {
  const SettingsDraft& draft;
  std::uint64_t settings = 0;  // number of the values that hold
  SensorKind sensor = SensorKind::colour;
  const std::filesystem::path& file;    // empty: there is none
  const std::filesystem::path& record;  // likewise
  const std::vector<ModelColours>& models;
  const std::vector<AdjustableControl>& controls;
  bool has_camera = false;            // streaming
  const PlayControl* play = nullptr;  // null: frames come from a camera
};

// One JSON object: {settings, sensor, file, record, changed, fault, values: [{key, unit, words,
// kind, least, most, value, otherwise, changed, of_range}], region, region_words, controls: [{name,
// words, kind, least, most, step, usual, value, inactive, fixed, items}], models, paused}.
std::string state_text(const BenchState& state);

}  // namespace aspect
