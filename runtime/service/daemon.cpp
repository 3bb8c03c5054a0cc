// One thread waits for the camera and does everything with its frame before it waits again; a
// second one, in Outputs, does all writing. What is not about frames (another state, a reload) may
// allocate and takes the time that it takes: the camera's newest frame is what counts then.
#include "runtime/service/daemon.h"

#include <fmt/format.h>
#include <array>
#include <csignal>

#include "runtime/capture/camera_search.h"
#include "runtime/service/daemon_log.h"
#include "runtime/service/recognition_json.h"
#include "runtime/service/state_json.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

// The service manager hears of us at least so often, whatever the camera does.
constexpr std::chrono::milliseconds kHeartbeat{250};
// A camera may damage every frame for hours.
constexpr std::chrono::seconds kDamageInterval{1};

double seconds_since_1970(Clock::time_point time) {
  const auto ago = Clock::now() - time;
  const auto wall = std::chrono::system_clock::now().time_since_epoch() - ago;
  return std::chrono::duration<double>(wall).count();
}

std::string_view status_of(std::span<char> out, std::string_view state, std::string_view reason) {
  const auto end = fmt::format_to_n(out.data(), out.size(), "STATUS={}{}{}", state,
                                    reason.empty() ? "" : ": ", reason);
  return {out.data(), std::min(end.size, out.size())};
}

}  // namespace

Result<std::unique_ptr<Daemon>> Daemon::start(const std::filesystem::path& file,
                                              const DaemonParts& parts) {
  std::unique_ptr<Daemon> daemon(new Daemon(file, parts));
  if (auto error = daemon->prepare()) return *error;
  return daemon;
}

std::optional<Error> Daemon::prepare() {
  Result<std::unique_ptr<RuntimeSetup>> setup = load_setup(file_);
  if (!setup) return Error{setup.error()};
  line_.resize(Outputs::kMaxLineBytes);
  if (parts_.make_workbench != nullptr) workbench_ = parts_.make_workbench(parts_.calls);
  take_room(std::move(setup).value());
  const Configuration& configuration = setup_->configuration;
  Result<std::unique_ptr<Outputs>> outputs = Outputs::open(configuration.output, workbench_.get());
  if (!outputs) return Error{outputs.error()};
  outputs_ = std::move(outputs).value();
  tell_address();
  camera_ = make_camera(configuration.capture);
  return apply(configuration.process);
}

std::unique_ptr<Camera> Daemon::make_camera(const CameraSettings& settings) const {
  if (parts_.calls != nullptr)
    return std::make_unique<Camera>(settings, *parts_.calls, DeviceFolders{});
  return std::make_unique<Camera>(settings);
}

// Who can read the log may use the workbench.
void Daemon::tell_address() const {
  if (const std::string address = outputs_->http_address(); !address.empty())
    log_line("page: " + address);
}

void Daemon::use_workbench() {
  if (!workbench_) return;
  workbench_->use({setup_->configuration, file_, setup_->indexes, setup_->parameters,
                   [file = file_](const std::string& text) { return check_setup(text, file); }});
}

// Of the page, between two frames.
void Daemon::take_changes() {
  if (!workbench_) return;
  if (VisionParameters vision; workbench_->take_vision(vision)) recogniser_->cut_with(vision);
  std::vector<CameraControl>& controls = setup_->configuration.capture.controls;
  if (workbench_->take_controls(controls)) camera_->adopt_controls(controls);
}

// Memory for the frames that are asked for; a camera may give others, but hardly larger ones.
void Daemon::take_room(std::unique_ptr<RuntimeSetup> setup) {
  recogniser_.reset();
  setup_ = std::move(setup);
  for (const std::string& warning : setup_->warnings) log_line("warning: " + warning);
  const CameraSettings& capture = setup_->configuration.capture;
  recogniser_ = std::make_unique<SizedRecogniser>(setup_->indexes, setup_->parameters);
  recogniser_->make_room(capture.width_px, capture.height_px);
  use_workbench();
}

void Daemon::run() {
  manager_.tell("READY=1");
  log_line("ready");
  for (bool running = true; running;) {
    const CameraEvent event = camera_->next(kHeartbeat, signals_.descriptor());
    switch (event.kind) {
      case CameraEvent::Kind::frame:
        on_frame(event);
        break;
      case CameraEvent::Kind::damaged:
        on_damaged(event);
        break;
      case CameraEvent::Kind::changed:
        on_changed(event);
        break;
      case CameraEvent::Kind::woken:
        running = on_signal();
        break;
      case CameraEvent::Kind::nothing:
        break;
    }
    manager_.beat(Clock::now());
  }
  manager_.tell("STOPPING=1");
  log_line("stopped");
}

void Daemon::on_frame(const CameraEvent& event) {
  take_changes();
  const std::uint64_t missing = event.late + event.lost + damaged_;
  const Recognition recognition = recogniser_->recognise(
      event.frame,
      1 + static_cast<int>(std::min<std::uint64_t>(missing, std::uint64_t{kMostSearchEvery})));
  const CaptureLabel capture = {seconds_since_1970(event.captured), Clock::now() - event.captured,
                                event.late, event.lost, damaged_};
  const FrameLabel label = {camera_name(), event.sequence, event.frame.width_px,
                            event.frame.height_px, capture};
  damaged_ = 0;
  // The frame first: a page draws a line's boxes into the picture that it has.
  if (workbench_ && workbench_->wants_frame())
    workbench_->show(event.frame, recognition, recogniser_->cameras(), outputs_->counts().lines);
  const std::size_t length = write_recognition_json(label, recognition, setup_->indexes, line_);
  outputs_->publish({line_.data(), length});

  std::array<SeenName, kMaxBlobs> seen;
  std::size_t count = 0;
  for (const SeenObject& object : recognition.objects) {
    const Verdict verdict = object.judgement.verdict;
    if (object.hypotheses.empty() || verdict == Verdict::unknown || verdict == Verdict::ambiguous)
      continue;
    const Hypothesis& best = object.hypotheses.front();
    seen[count++] = {setup_->indexes[best.index].object, best.score};
  }
  outputs_->report_seen(std::span(seen).first(count));
}

void Daemon::on_damaged(const CameraEvent& event) {
  ++damaged_;
  const auto now = Clock::now();
  if (now - damage_reported_ < kDamageInterval) return;
  damage_reported_ = now;
  report("damaged", event.reason);
}

void Daemon::on_changed(const CameraEvent& event) {
  if (event.state == CameraState::streaming) {
    const CameraPlan& plan = camera_->plan();
    log_line(describe(plan));
    for (const std::string& warning : plan.warnings) log_line("warning: " + warning);
    recogniser_->make_room(plan.width_px, plan.height_px);
  }
  if (workbench_)
    workbench_->use_camera(event.state == CameraState::streaming ? &camera_->plan() : nullptr);
  report(name_of(event.state), event.reason);
}

// False: it is time to go.
bool Daemon::on_signal() {
  while (const int signal = signals_.take()) {
    if (signal != SIGHUP) return false;
    manager_.tell_reloading();
    const auto error = reload();
    report(error ? "reload_failed" : "reloaded", error ? error->message : "");
    manager_.tell("READY=1");
  }
  return true;
}

std::optional<Error> Daemon::reload() {
  Result<std::unique_ptr<RuntimeSetup>> loaded = load_setup(file_);
  if (!loaded) return Error{loaded.error()};
  const Configuration old = setup_->configuration;
  const Configuration& configuration = loaded.value()->configuration;
  if (configuration.output != old.output)
    if (auto error = reopen_outputs(configuration.output)) return error;
  if (configuration.process != old.process)
    log_line("warning: [process] takes effect with a restart");
  take_room(std::move(loaded).value());
  if (setup_->configuration.capture != old.capture) {
    camera_.reset();  // it may be the same device
    if (workbench_) workbench_->use_camera(nullptr);
    camera_ = make_camera(setup_->configuration.capture);
  } else if (const CameraPlan& plan = camera_->plan(); plan.width_px > 0) {
    recogniser_->make_room(plan.width_px, plan.height_px);
  }
  return std::nullopt;
}

// The old outputs are closed first, since the new ones may use the same ports and files.
std::optional<Error> Daemon::reopen_outputs(const OutputSettings& settings) {
  outputs_.reset();
  Result<std::unique_ptr<Outputs>> opened = Outputs::open(settings, workbench_.get());
  std::optional<Error> error;
  if (!opened) {
    error = Error{opened.error()};
    opened = Outputs::open(setup_->configuration.output, workbench_.get());
    if (!opened) {
      log_line("the former outputs cannot be had again: " + opened.error());
      opened = Outputs::open({});
    }
  }
  outputs_ = std::move(opened).value();
  tell_address();
  return error;
}

void Daemon::report(std::string_view state, std::string_view reason) {
  log_line(fmt::format("{}: {}{}{}", camera_name(), state, reason.empty() ? "" : ": ", reason));
  const double now_s = seconds_since_1970(Clock::now());
  const std::size_t length = write_state_json(state, camera_name(), reason, now_s, line_);
  outputs_->publish({line_.data(), length});
  std::array<char, 256> status;
  manager_.tell(status_of(status, state, reason));
}

}  // namespace aspect
