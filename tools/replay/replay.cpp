#include "tools/replay/replay.h"

#include <fmt/format.h>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <new>
#include <thread>

#include "runtime/capture/recorded_frames.h"
#include "runtime/service/recognition_json.h"
#include "tools/replay/console.h"
#include "tools/replay/index_set.h"
#include "tools/replay/line_output.h"
#include "tools/replay/sized_recogniser.h"
#include "tools/replay/stage_pictures.h"

namespace aspect {
namespace {

// Holds the longest line there can be: 64 objects with 64 hypotheses of 48 contours each.
constexpr std::size_t kLineBytes = 8U << 20U;

// Lets frames start at a steady rate. One that comes late moves all that follow.
class Pace {
 public:
  explicit Pace(std::optional<double> fps) {
    if (fps) period_ = std::chrono::duration_cast<Clock::duration>(Seconds(1 / *fps));
  }
  void wait() {
    std::this_thread::sleep_until(next_);
    next_ = std::max(next_, Clock::now() - period_) + period_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  Clock::duration period_{};
  Clock::time_point next_ = Clock::now();
};

// One frame after the other. False: the output has gone, there is no point in going on.
class FrameLoop {
 public:
  FrameLoop(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters,
            const StagePictures& pictures, Console& console)
      : indexes_(indexes),
        recogniser_(indexes, parameters),
        pictures_(pictures),
        console_(console),
        line_(kLineBytes) {}

  bool process(const CapturedFrame& frame) {
    try {
      recogniser_.make_room(frame.width_px, frame.height_px);
      const Recognition recognition = recogniser_.recognise(frame.view());
      if (!write(frame, recognition)) return false;
      if (auto error = pictures_.write(frame, recognition, recogniser_.regions(), indexes_))
        console_.fail(error->message);
    } catch (const std::bad_alloc&) {
      console_.fail(fmt::format("{}: {} x {} px need more memory than there is; scale it down",
                                frame.name, frame.width_px, frame.height_px));
    }
    return true;
  }

 private:
  bool write(const CapturedFrame& frame, const Recognition& recognition) {
    const FrameLabel label = {frame.name, frame.sequence, frame.width_px, frame.height_px};
    const std::size_t length = write_recognition_json(label, recognition, indexes_, line_);
    const OutputStatus status = write_line({line_.data(), length});
    if (status == OutputStatus::failed)
      console_.fail(fmt::format("standard output: {}; stopped", std::strerror(errno)));
    return status == OutputStatus::written;
  }

  std::span<const ClassIndex> indexes_;
  SizedRecogniser recogniser_;
  const StagePictures& pictures_;
  Console& console_;
  std::vector<char> line_;
};

void process_all(RecordedFrames& frames, std::optional<double> pace_fps, FrameLoop& loop,
                 Console& console) {
  Pace pace(pace_fps);
  CapturedFrame frame;
  for (;;) {
    const FrameStatus status = frames.next(frame);
    if (status == FrameStatus::end) return;
    console.progress(frame.sequence + 1, frames.count(), frame.name);
    if (status == FrameStatus::failed) {
      console.fail(frame.error);
      continue;
    }
    pace.wait();
    if (!loop.process(frame)) return;
  }
}

}  // namespace

int replay(const ReplayOptions& options) {
  constexpr int kFailed = 1;
  Console console("aspect-replay");
  Configuration configuration;
  if (options.configuration) {
    Result<Configuration> read = read_configuration(*options.configuration);
    if (!read) return console.fail(read.error()), kFailed;
    configuration = std::move(read).value();
  }
  const std::vector<ClassIndex> indexes = load_indexes(options.indexes, console);
  if (indexes.empty()) return kFailed;
  const auto pictures = StagePictures::create(options.overlay_folder, options.dump_folder);
  if (!pictures) return console.fail(pictures.error()), kFailed;

  RecogniserParameters parameters;
  parameters.vision = indexes.front().vision;
  configuration.apply(parameters);
  options.recognition.apply(parameters);

  RecordedFrames frames(options.frames, parameters.vision.sensor);
  FrameLoop loop(indexes, parameters, pictures.value(), console);
  process_all(frames, options.pace_fps, loop, console);
  return console.failures() == 0 ? 0 : kFailed;
}

}  // namespace aspect
