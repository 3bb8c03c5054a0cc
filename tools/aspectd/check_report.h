// What aspectd would use: found by a check, printed in words or as JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "runtime/capture/camera.h"
#include "runtime/output/output_settings.h"
#include "runtime/vision/frame.h"

namespace aspect {

struct CheckedIndex {
  std::string object;
  std::size_t classes = 0, key_views = 0;
};

struct CheckReport {
  std::optional<CameraPlan> camera;
  std::vector<CheckedIndex> indexes;
  Box region_of_interest{};
  std::size_t memory_bytes = 0;
  int width_px = 0, height_px = 0;  // of the frames that it is for
  OutputSettings outputs;
  std::vector<std::string> warnings, errors;  // of the camera and the outputs too
};

std::string check_text(const CheckReport& report);
std::string check_json(const CheckReport& report);

}  // namespace aspect
