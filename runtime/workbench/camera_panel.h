// The controls of a camera that somebody else streams from: the driver lets its settings be seen
// and changed through a descriptor of one's own.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/capture/camera_control_list.h"
#include "runtime/capture/camera_settings.h"

namespace aspect {

class CameraPanel {
 public:
  explicit CameraPanel(V4l2Calls& calls) : calls_(calls) {}

  // Its node; empty: there is none now.
  void use(const std::string& node);

  // As of a second ago at most; none without a camera.
  std::vector<AdjustableControl> controls();

  struct Set {
    CameraControl control;      // with the value that it has now
    bool is_automatic = false;  // switches others on and off
    bool is_button = false;     // has no value to keep
    std::vector<std::string> warnings;
  };
  [[nodiscard]] Result<Set> set(const CameraControl& wanted);

 private:
  using Clock = std::chrono::steady_clock;

  V4l2Calls& calls_;
  std::mutex mutex_;
  std::string node_;
  std::vector<AdjustableControl> controls_;
  Clock::time_point listed_{};
};

}  // namespace aspect
