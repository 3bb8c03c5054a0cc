// One thread has the frames and recognises them at their pace; the page's threads do the rest, as
// with aspectd. While frames stand still, a value that the page changes has the same frame
// recognised again.
#include "tools/replay/serve.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <memory>
#include <new>
#include <vector>

#include "runtime/capture/recorded_frames.h"
#include "runtime/output/outputs.h"
#include "runtime/recognition/sized_recogniser.h"
#include "runtime/service/recognition_json.h"
#include "runtime/workbench/workbench_desk.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kUsualRate_hz = 15;
// Standing still, changes are looked for so often.
constexpr std::chrono::milliseconds kLook{10};

// SIGINT and SIGTERM as something to wait for.
class EndSignals {
 public:
  // Before any thread is started.
  EndSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }
  // Waits so long; true where it is time to go.
  bool come_within(Clock::duration duration) {
    const auto rest = std::max<std::chrono::nanoseconds>(duration, std::chrono::nanoseconds(0));
    constexpr std::int64_t kSecond_ns = 1'000'000'000;
    const timespec time{static_cast<time_t>(rest.count() / kSecond_ns),
                        static_cast<long>(rest.count() % kSecond_ns)};
    return sigtimedwait(&signals_, nullptr, &time) > 0;
  }

 private:
  sigset_t signals_{};
};

HttpOutput page_settings(const ReplayOptions& options, const Configuration& configuration) {
  HttpOutput settings = configuration.output.http.value_or(HttpOutput{});
  if (options.address) settings.address = *options.address;
  if (options.port) settings.port = *options.port;
  if (options.record_folder) settings.record = *options.record_folder;
  return settings;
}

class ServedFrames {
 public:
  ServedFrames(const ReplayOptions& options, std::span<const ClassIndex> indexes,
               const RecogniserParameters& parameters, Console& console)
      : options_(options),
        indexes_(indexes),
        parameters_(parameters),
        console_(console),
        recogniser_(indexes, parameters),
        line_(Outputs::kMaxLineBytes) {}

  // False: there is no page; the console has said why.
  bool open(Configuration configuration) {
    desk_ = make_workbench({nullptr, &play_});
    configuration.output.http = page_settings(options_, configuration);
    const std::filesystem::path file = options_.configuration.value_or("");
    if (desk_)
      desk_->use({configuration, file, indexes_, parameters_,
                  [file](const std::string& text) -> std::optional<Error> {
                    const auto read = parse_configuration(text, file.native());
                    return read ? std::nullopt : std::optional(Error{read.error()});
                  }});
    OutputSettings settings;
    settings.http = configuration.output.http;
    Result<std::unique_ptr<Outputs>> outputs = Outputs::open(settings, desk_.get());
    if (!outputs) return console_.fail(outputs.error()), false;
    outputs_ = std::move(outputs).value();
    console_.tell("page: " + outputs_->http_address());
    return true;
  }

  bool run() {
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(1 / options_.pace_fps.value_or(kUsualRate_hz)));
    Clock::time_point due = Clock::now();
    while (!end_.come_within(std::min<Clock::duration>(due - Clock::now(), kLook))) {
      const bool changed = take_changes();
      const bool steps = play_.steps > 0;
      if (play_.paused && !steps) {
        if (changed && has_frame_) show();
        due = Clock::now() + kLook;
        continue;
      }
      if (Clock::now() < due) continue;
      if (steps) --play_.steps;
      if (!next()) return false;
      show();
      due = std::max(due + period, Clock::now() - period);
    }
    return true;
  }

 private:
  bool take_changes() {
    VisionParameters vision;
    if (!desk_->take_vision(vision)) return false;
    recogniser_.cut_with(vision);
    return true;
  }

  // The next frame that can be read; after the last one the first. False: there is none at all.
  bool next() {
    // The rest of this round, and a whole new one.
    for (int round = 0; round < 2; ++round) {
      if (!frames_)
        frames_ = std::make_unique<RecordedFrames>(options_.frames, parameters_.vision.sensor);
      for (;;) {
        const FrameStatus status = frames_->next(frame_);
        if (status == FrameStatus::frame) return has_frame_ = true;
        if (status == FrameStatus::end) break;
        // Once is enough.
        if (!told_) console_.fail(frame_.error);
      }
      told_ = true;
      frames_.reset();
    }
    if (console_.failures() == 0) console_.fail("no frame can be read; give others");
    return false;
  }

  void show() {
    try {
      recogniser_.make_room(frame_.width_px, frame_.height_px);
      const Recognition recognition = recogniser_.recognise(frame_.view());
      if (desk_->wants_frame())
        desk_->show(frame_.view(), recognition, recogniser_.cameras(), outputs_->counts().lines);
      const FrameLabel label = {frame_.name, sequence_++, frame_.width_px, frame_.height_px};
      const std::size_t length = write_recognition_json(label, recognition, indexes_, line_);
      outputs_->publish({line_.data(), length});
    } catch (const std::bad_alloc&) {
      console_.fail(frame_.name + ": needs more memory than there is; scale it down");
    }
  }

  const ReplayOptions& options_;
  std::span<const ClassIndex> indexes_;
  const RecogniserParameters& parameters_;
  Console& console_;
  EndSignals end_;
  PlayControl play_;
  std::unique_ptr<Workbench> desk_;
  std::unique_ptr<Outputs> outputs_;  // after the desk
  SizedRecogniser recogniser_;
  std::vector<char> line_;
  std::unique_ptr<RecordedFrames> frames_;
  CapturedFrame frame_;
  bool has_frame_ = false, told_ = false;
  std::uint64_t sequence_ = 0;
};

}  // namespace

bool serve(const ReplayOptions& options, Configuration configuration,
           std::span<const ClassIndex> indexes, const RecogniserParameters& parameters,
           Console& console) {
  ServedFrames served(options, indexes, parameters, console);
  return served.open(std::move(configuration)) && served.run();
}

}  // namespace aspect
