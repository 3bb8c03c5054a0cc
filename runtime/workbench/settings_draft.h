// What the page has changed of a configuration and not written yet: values of [segmentation] and
// of [camera.controls].
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "runtime/capture/camera_settings.h"
#include "runtime/recognition/recogniser.h"
#include "runtime/service/configuration.h"
#include "runtime/workbench/toml_edit.h"

namespace aspect {

class SettingsDraft {
 public:
  // What the file says, and what holds where it says nothing.
  void start(const Configuration& configuration, const VisionParameters& otherwise);

  // An object of values by key, as in the file; null takes a key out of it. All of it becomes part
  // of the draft, also what is no good: then that is the error, and values() have what the file
  // says in its place.
  [[nodiscard]] std::optional<Error> change(const nlohmann::json& values);
  void forget_values();
  void change_control(const CameraControl& control, bool is_automatic);

  // Why the draft cannot be used as it is, as --check says.
  const Error* fault() const { return faults_.empty() ? nullptr : &faults_.begin()->second; }
  bool is_fault(const std::string& key) const { return faults_.contains(key); }
  bool is_changed() const { return !changes_.empty() || !controls_.empty(); }
  const std::map<std::string, nlohmann::json>& changes() const { return changes_; }

  const VisionParameters& values() const { return values_; }
  // What holds where the file says nothing.
  const VisionParameters& otherwise() const { return otherwise_; }
  // Of the file and the page, in the order in which they are to be set.
  std::vector<CameraControl> controls() const;

  // For the file.
  std::vector<TomlEdit> edits() const;

 private:
  void read();

  SegmentationOverrides of_file_;
  std::vector<CameraControl> controls_of_file_;
  VisionParameters otherwise_, values_;
  std::map<std::string, nlohmann::json> changes_;
  struct ChangedControl {
    CameraControl control;
    bool is_automatic;
  };
  std::vector<ChangedControl> controls_;
  std::map<std::string, Error> faults_;  // by key
};

}  // namespace aspect
