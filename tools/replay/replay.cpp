#include "tools/replay/replay.h"

#include <fmt/format.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/capture/recorded_frames.h"
#include "runtime/recognition/self_test.h"
#include "runtime/recognition/sized_recogniser.h"
#include "runtime/service/index_set.h"
#include "runtime/service/recognition_json.h"
#include "tools/replay/console.h"
#include "tools/replay/frame_explainer.h"
#include "tools/replay/line_output.h"
#include "tools/replay/pace.h"
#include "tools/replay/replay_page.h"
#include "tools/replay/serve.h"
#include "tools/replay/stage_pictures.h"
#include "tools/replay/thesis_index.h"

namespace aspect {
namespace {

// Holds the longest line there can be: 64 objects with 64 hypotheses of 48 contours each. Memory is
// taken for what is used of it only.
constexpr std::size_t kLineBytes = 8U << 20U;

// One frame after the other. False: where all of it should go has gone, there is no point in going
// on.
class FrameLoop {
 public:
  FrameLoop(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters,
            const StagePictures& pictures, Console& console, FrameExplainer* explainer,
            std::optional<BopRows> bop, std::unique_ptr<ReplayPage> page, bool thesis_index)
      : indexes_(indexes),
        recogniser_(indexes, parameters),
        pictures_(pictures),
        console_(console),
        line_(std::make_unique_for_overwrite<char[]>(kLineBytes)),
        explainer_(explainer),
        thesis_index_(thesis_index),
        bop_(std::move(bop)),
        page_(std::move(page)) {
    if (bop_) writes_ = put(BopRows::head());
  }

  bool process(const CapturedFrame& frame) {
    try {
      recogniser_.make_room(frame.width_px, frame.height_px);
      const Recognition recognition = recogniser_.recognise(frame.view(), steps_to(frame));
      if (explainer_ != nullptr)
        explanations_ = explainer_->explain(frame.view(), recognition, recogniser_);
      if (writes_) writes_ = write(frame, recognition);
      if (!writes_ && !page_) return false;
      if (auto error = pictures_.write(frame, recognition, recogniser_.regions(), indexes_,
                                       recogniser_.cameras()))
        console_.fail(error->message);
      if (page_) check_page(page_->add(frame, recognition, recogniser_));
    } catch (const std::bad_alloc&) {
      fail(frame, fmt::format("{}: {} x {} px need more memory than there is; scale it down",
                              frame.name, frame.width_px, frame.height_px));
    }
    return writes_ || page_;
  }

  void fail(const CapturedFrame& frame, const std::string& error) {
    console_.fail(error);
    if (page_) check_page(page_->add_failed(frame, error));
  }

  void finish() {
    if (page_) check_page(page_->finish());
  }

 private:
  void check_page(const std::optional<Error>& error) {
    if (!error) return;
    console_.fail(error->message);
    page_.reset();
  }

  // Frames that could not be read count.
  int steps_to(const CapturedFrame& frame) {
    const std::uint64_t last = std::exchange(last_sequence_, frame.sequence);
    return frame.sequence > last ? static_cast<int>(std::min<std::uint64_t>(
                                       frame.sequence - last, std::uint64_t{kMostSearchEvery}))
                                 : 1;
  }

  bool write(const CapturedFrame& frame, const Recognition& recognition) {
    if (bop_) {
      const Result<std::string> rows = bop_->rows(frame.name, recognition);
      if (!rows) return console_.fail(rows.error()), true;
      return put(rows.value());
    }
    if (thesis_index_) return put(thesis_index_text(frame.name, recognition, indexes_.front()));
    const FrameLabel label = {frame.name, frame.sequence, frame.width_px, frame.height_px};
    const std::size_t length = write_recognition_json(label, recognition, indexes_,
                                                      {line_.get(), kLineBytes}, explanations_);
    return put({line_.get(), length});
  }

  bool put(std::string_view text) {
    const OutputStatus status = write_line(text);
    if (status == OutputStatus::failed)
      console_.fail(fmt::format("standard output: {}; stopped", std::strerror(errno)));
    return status == OutputStatus::written;
  }

  std::span<const ClassIndex> indexes_;
  SizedRecogniser recogniser_;
  const StagePictures& pictures_;
  Console& console_;
  std::unique_ptr<char[]> line_;
  FrameExplainer* explainer_;  // null: nobody asked
  bool thesis_index_;
  std::vector<std::string> explanations_;
  std::uint64_t last_sequence_ = 0;
  bool writes_ = true;                // false: the output has gone
  std::optional<BopRows> bop_;        // nothing: lines
  std::unique_ptr<ReplayPage> page_;  // null: nobody asked, or it has failed
};

// False: the output has gone.
bool process_all(RecordedFrames& frames, Pace& pace, FrameLoop& loop, Console& console) {
  CapturedFrame frame;
  for (;;) {
    const FrameStatus status = frames.next(frame);
    if (status == FrameStatus::end) return true;
    console.progress(frame.sequence + 1, frames.count(), frame.name);
    if (status == FrameStatus::failed) {
      loop.fail(frame, frame.error);
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

Result<Configuration> configuration_of(const ReplayOptions& options) {
  if (!options.configuration) return Configuration();
  return read_configuration(*options.configuration);
}

Result<RecogniserParameters> parameters_for(const ReplayOptions& options,
                                            std::span<const ClassIndex> indexes) {
  const Result<Configuration> configuration = configuration_of(options);
  if (!configuration) return Error{configuration.error()};
  RecogniserParameters parameters;
  parameters.vision = indexes.front().vision;
  configuration.value().apply(parameters);
  options.recognition.apply(parameters);
  if (options.thesis_index && indexes.size() > 1)
    return Error{
        fmt::format("--thesis-index: classes of {} objects would have the same numbers; give one "
                    "index at a time",
                    indexes.size())};
  if (options.thesis_index) rank_as_thesis(indexes.front(), parameters);
  TrackingParameters& tracking = parameters.tracking;
  if (tracking.on && options.explain && !options.explain->empty())
    return Error{"--explain " + *options.explain +
                 ": what was not chosen is not followed; leave --track out"};
  // What is only followed has no contours to explain it by.
  if (options.explain) tracking.search_every = 1;
  return parameters;
}

// Null where nobody asked.
Result<std::unique_ptr<FrameExplainer>> explainer_for(const ReplayOptions& options,
                                                      std::span<const ClassIndex> indexes,
                                                      const RecogniserParameters& parameters) {
  if (!options.explain) return std::unique_ptr<FrameExplainer>();
  auto explainer = std::make_unique<FrameExplainer>(indexes);
  if (!options.explain->empty()) {
    const Result<ExpectedHypothesis> expected = find_expected(*options.explain, indexes);
    if (!expected) return Error{expected.error()};
    explainer->expect(parameters, expected.value());
  }
  return explainer;
}

Result<std::optional<BopRows>> bop_rows_for(const ReplayOptions& options, std::size_t objects) {
  if (!options.bop) return std::optional<BopRows>();
  if (options.bop->objects.size() != objects)
    return Error{
        fmt::format("--bop: {} ids for {} loaded objects; give one for each, in the "
                    "order of the indexes, with commas between",
                    options.bop->objects.size(), objects)};
  return std::optional<BopRows>(*options.bop);
}

}  // namespace

int replay(const ReplayOptions& options) {
  constexpr int kFailed = 1;
  Console console("aspect-replay");
  const IndexSet set = load_indexes(options.indexes);
  for (const std::string& failure : set.failures) console.fail(failure);
  for (const std::string& warning : set.warnings) console.warn(warning);
  const std::vector<ClassIndex>& indexes = set.indexes;
  if (indexes.empty()) return kFailed;
  if (options.self_test) {
    test_indexes(indexes, console);
    return console.failures() == 0 ? 0 : kFailed;
  }
  const auto parameters = parameters_for(options, indexes);
  if (!parameters) return console.fail(parameters.error()), kFailed;
  if (options.serve) {
    auto configuration = configuration_of(options);
    if (!configuration) return console.fail(configuration.error()), kFailed;
    return serve(options, std::move(configuration).value(), indexes, parameters.value(), console)
               ? 0
               : kFailed;
  }
  const auto pictures = StagePictures::create(options.overlay_folder, options.dump_folder);
  if (!pictures) return console.fail(pictures.error()), kFailed;
  auto explainer = explainer_for(options, indexes, parameters.value());
  if (!explainer) return console.fail(explainer.error()), kFailed;
  auto bop = bop_rows_for(options, indexes.size());
  if (!bop) return console.fail(bop.error()), kFailed;
  auto page = create_replay_page(options, indexes, parameters.value());
  if (!page) return console.fail(page.error()), kFailed;

  RecordedFrames frames(options.frames, parameters.value().vision.sensor);
  FrameLoop loop(indexes, parameters.value(), pictures.value(), console, explainer.value().get(),
                 std::move(bop).value(), std::move(page).value(), options.thesis_index);
  Pace pace(options.pace_fps);
  const bool finished = process_all(frames, pace, loop, console);
  loop.finish();
  if (const std::string report = pace.report(); finished && !report.empty()) console.tell(report);
  return console.failures() == 0 ? 0 : kFailed;
}

}  // namespace aspect
