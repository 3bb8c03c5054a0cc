#include "tools/replay/replay.h"

#include <fmt/format.h>
#include <cerrno>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <vector>

#include "runtime/capture/recorded_frames.h"
#include "runtime/recognition/self_test.h"
#include "runtime/recognition/sized_recogniser.h"
#include "runtime/service/index_set.h"
#include "runtime/service/recognition_json.h"
#include "tools/replay/console.h"
#include "tools/replay/explanation_json.h"
#include "tools/replay/line_output.h"
#include "tools/replay/pace.h"
#include "tools/replay/stage_pictures.h"

namespace aspect {
namespace {

// Holds the longest line there can be: 64 objects with 64 hypotheses of 48 contours each. Memory is
// taken for what is used of it only.
constexpr std::size_t kLineBytes = 8U << 20U;

class FrameExplainer {
 public:
  explicit FrameExplainer(std::span<const ClassIndex> indexes) : indexes_(indexes) {}

  void expect(const RecogniserParameters& parameters, const ExpectedHypothesis& expected) {
    rivals_.emplace(indexes_, parameters, expected);
  }

  // Of each object.
  std::vector<std::string> explain(const CapturedFrame& frame, const Recognition& recognition,
                                   const SizedRecogniser& recogniser) {
    if (rivals_) {
      rivals_->make_room(frame.width_px, frame.height_px);
      rivals_->look(frame.view());
    }
    const SeenFrame seen = {recognition.graph, &recogniser.regions(), &recogniser.colours(),
                            indexes_, recogniser.cameras()};
    std::vector<std::string> explanations;
    for (std::size_t k = 0; k < recognition.objects.size(); ++k) {
      const auto list = recognition.objects[k].hypotheses;
      SeenExplanation best;
      if (!list.empty()) best = explain_seen(list.front(), list.front().pose, k, seen);
      std::optional<RivalExplanation> rival;
      if (rivals_) rival = rivals_->explain(k);
      explanations.push_back(explanation_json(best, rival ? &*rival : nullptr, indexes_));
    }
    return explanations;
  }

 private:
  std::span<const ClassIndex> indexes_;
  std::optional<RivalExplainer> rivals_;
};

// One frame after the other. False: the output has gone, there is no point in going on.
class FrameLoop {
 public:
  FrameLoop(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters,
            const StagePictures& pictures, Console& console, FrameExplainer* explainer)
      : explainer_(explainer),
        indexes_(indexes),
        recogniser_(indexes, parameters),
        pictures_(pictures),
        console_(console),
        line_(std::make_unique_for_overwrite<char[]>(kLineBytes)) {}

  bool process(const CapturedFrame& frame) {
    try {
      recogniser_.make_room(frame.width_px, frame.height_px);
      const Recognition recognition = recogniser_.recognise(frame.view());
      if (explainer_ != nullptr)
        explanations_ = explainer_->explain(frame, recognition, recogniser_);
      if (!write(frame, recognition)) return false;
      if (auto error = pictures_.write(frame, recognition, recogniser_.regions(), indexes_,
                                       recogniser_.cameras()))
        console_.fail(error->message);
    } catch (const std::bad_alloc&) {
      console_.fail(fmt::format("{}: {} x {} px need more memory than there is; scale it down",
                                frame.name, frame.width_px, frame.height_px));
    }
    return true;
  }

 private:
  FrameExplainer* explainer_;  // null: nobody asked
  std::vector<std::string> explanations_;
  bool write(const CapturedFrame& frame, const Recognition& recognition) {
    const FrameLabel label = {frame.name, frame.sequence, frame.width_px, frame.height_px};
    const std::size_t length = write_recognition_json(label, recognition, indexes_,
                                                      {line_.get(), kLineBytes}, explanations_);
    const OutputStatus status = write_line({line_.get(), length});
    if (status == OutputStatus::failed)
      console_.fail(fmt::format("standard output: {}; stopped", std::strerror(errno)));
    return status == OutputStatus::written;
  }

  std::span<const ClassIndex> indexes_;
  SizedRecogniser recogniser_;
  const StagePictures& pictures_;
  Console& console_;
  std::unique_ptr<char[]> line_;
};

// False: the output has gone.
bool process_all(RecordedFrames& frames, Pace& pace, FrameLoop& loop, Console& console) {
  CapturedFrame frame;
  for (;;) {
    const FrameStatus status = frames.next(frame);
    if (status == FrameStatus::end) return true;
    console.progress(frame.sequence + 1, frames.count(), frame.name);
    if (status == FrameStatus::failed) {
      console.fail(frame.error);
      continue;
    }
    pace.wait();
    if (!loop.process(frame)) return false;
    pace.finish();
  }
}

// One line an index: on standard output, and for one that fails on standard error.
void test_indexes(std::span<const ClassIndex> indexes, Console& console) {
  for (const ClassIndex& index : indexes) {
    const SelfTestResult result = self_test(index);
    if (result.outcome == SelfTestResult::Outcome::failed) {
      console.fail(result.line);
    } else if (write_line(result.line + "\n") == OutputStatus::failed) {
      console.fail(fmt::format("standard output: {}; stopped", std::strerror(errno)));
      return;
    }
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
  const IndexSet set = load_indexes(options.indexes);
  for (const std::string& failure : set.failures) console.fail(failure);
  for (const std::string& warning : set.warnings) console.warn(warning);
  const std::vector<ClassIndex>& indexes = set.indexes;
  if (indexes.empty()) return kFailed;
  if (options.self_test) {
    test_indexes(indexes, console);
    return console.failures() == 0 ? 0 : kFailed;
  }
  const auto pictures = StagePictures::create(options.overlay_folder, options.dump_folder);
  if (!pictures) return console.fail(pictures.error()), kFailed;

  RecogniserParameters parameters;
  parameters.vision = indexes.front().vision;
  configuration.apply(parameters);
  options.recognition.apply(parameters);

  std::optional<FrameExplainer> explainer;
  if (options.explain) explainer.emplace(indexes);
  if (options.explain && !options.explain->empty()) {
    const Result<ExpectedHypothesis> expected = find_expected(*options.explain, indexes);
    if (!expected) return console.fail(expected.error()), kFailed;
    explainer->expect(parameters, expected.value());
  }

  RecordedFrames frames(options.frames, parameters.vision.sensor);
  FrameLoop loop(indexes, parameters, pictures.value(), console, explainer ? &*explainer : nullptr);
  Pace pace(options.pace_fps);
  const bool finished = process_all(frames, pace, loop, console);
  if (const std::string report = pace.report(); finished && !report.empty()) console.tell(report);
  return console.failures() == 0 ? 0 : kFailed;
}

}  // namespace aspect
