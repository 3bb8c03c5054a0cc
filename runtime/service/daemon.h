// aspectd: a camera in, one line of JSON a frame out, for years.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/capture/camera.h"
#include "runtime/output/outputs.h"
#include "runtime/recognition/sized_recogniser.h"
#include "runtime/service/runtime_setup.h"
#include "runtime/service/service_notify.h"
#include "runtime/service/signal_descriptor.h"
#include "runtime/service/workbench.h"

namespace aspect {

// What a daemon does not make itself.
struct DaemonParts {
  MakeWorkbench make_workbench = nullptr;  // for the page; null: it shows lines only
  V4l2Calls* calls = nullptr;              // another kernel than the one that this runs on
};

class Daemon {
 public:
  // Loads and tests everything, opens the outputs and takes all memory. The camera need not be
  // there. One line where something is wrong.
  static Result<std::unique_ptr<Daemon>> start(const std::filesystem::path& file,
                                               const DaemonParts& parts = {});

  // Until SIGTERM or SIGINT. SIGHUP reads the configuration and the indexes anew; a new one that is
  // no good leaves the old one running. Between two frames of an undisturbed camera it allocates
  // nothing.
  void run();

 private:
  Daemon(std::filesystem::path file, const DaemonParts& parts)
      : file_(std::move(file)), parts_(parts) {}
  std::optional<Error> prepare();
  void take_room(std::unique_ptr<RuntimeSetup> setup);
  void use_workbench();
  std::unique_ptr<Camera> make_camera(const CameraSettings& settings) const;
  void tell_address() const;
  void take_changes();
  void on_frame(const CameraEvent& event);
  void on_damaged(const CameraEvent& event);
  void on_changed(const CameraEvent& event);
  bool on_signal();
  std::optional<Error> reload();
  std::optional<Error> reopen_outputs(const OutputSettings& settings);
  void report(std::string_view state, std::string_view reason);
  std::string_view camera_name() const { return setup_->configuration.capture.device; }

  std::filesystem::path file_;
  DaemonParts parts_;
  SignalDescriptor signals_;  // before any thread is started
  ServiceNotify manager_;
  std::unique_ptr<RuntimeSetup> setup_;
  std::unique_ptr<SizedRecogniser> recogniser_;
  std::unique_ptr<Workbench> workbench_;  // null: there is none
  std::unique_ptr<Outputs> outputs_;
  std::unique_ptr<Camera> camera_;
  std::vector<char> line_;
  std::uint64_t damaged_ = 0;  // since the last frame
  std::chrono::steady_clock::time_point damage_reported_{};
};

}  // namespace aspect
