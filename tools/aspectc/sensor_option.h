// --sensor, which compiling and rendering share.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "runtime/vision/sensor_kind.h"

namespace aspect {

inline void add_sensor_option(CLI::App& app, std::string& sensor) {
  app.add_option("--sensor", sensor, "what frames are of: colour, grey, range or surface ids")
      ->check(CLI::IsMember(std::vector<std::string>(kSensorNames.begin(), kSensorNames.end())))
      ->capture_default_str();
}

// `name` has passed the option's check.
inline SensorKind sensor_named(const std::string& name) {
  const auto* found = std::find(kSensorNames.begin(), kSensorNames.end(), name);
  return static_cast<SensorKind>(found - kSensorNames.begin());
}

}  // namespace aspect
