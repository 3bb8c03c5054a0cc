#include "tools/eval/clutter_evaluation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "runtime/recognition/sized_recogniser.h"
#include "tools/eval/test_bench.h"
#include "tools/score/scoring.h"

namespace aspect {
namespace {

PixelBox pixel_box(const Box& box) {
  return {static_cast<double>(box.x), static_cast<double>(box.y), static_cast<double>(box.width),
          static_cast<double>(box.height)};
}

RecogniserParameters parameters_of(std::span<const EvaluatedObject> objects,
                                   const EvaluationSettings& settings) {
  RecogniserParameters parameters;
  parameters.vision = objects.front().index.vision;
  parameters.camera = common_lens(objects);
  parameters.matching = settings.matching;
  parameters.ranking = settings.ranking;
  return parameters;
}

bool is_named(const SeenObject& seen) {
  return seen.judgement.verdict == Verdict::match && !seen.hypotheses.empty();
}

// As aspect-score: what overlaps the object most, by its name.
const SeenObject* find_object(const ClutteredFrame& frame, std::size_t place,
                              const Recognition& recognition) {
  const SeenObject* best = nullptr;
  double most = 0;
  if (!frame.has_object) return nullptr;
  for (const SeenObject& seen : recognition.objects) {
    if (!is_named(seen) || seen.hypotheses.front().index != place) continue;
    const double share = box_overlap(pixel_box(frame.box), pixel_box(seen.box));
    if (share < kLeastOverlap || share <= most) continue;
    most = share;
    best = &seen;
  }
  return best;
}

ClutterOutcome outcome_of(const EvaluatedObject& object, const ClutteredFrame& frame,
                          std::size_t place, const Recognition& recognition) {
  ClutterOutcome outcome;
  outcome.has_object = frame.has_object;
  outcome.visible = frame.visible;
  outcome.elapsed_ms = milliseconds(recognition.elapsed);
  const auto named =
      std::count_if(recognition.objects.begin(), recognition.objects.end(), is_named);
  const SeenObject* found = find_object(frame, place, recognition);
  outcome.found = found != nullptr;
  outcome.falsely_named = static_cast<std::size_t>(named) - (found != nullptr ? 1U : 0U);
  if (found != nullptr && found->hypotheses.front().pose != nullptr)
    outcome.pose = pose_error(object.index, frame.camera.intrinsics,
                              true_pose(frame.camera, object.scene.source_from_object),
                              found->hypotheses.front().pose->refined.pose);
  return outcome;
}

std::size_t range_of(double hidden) {
  std::size_t range = 0;
  while (range + 1 < kHiddenRanges.size() && hidden >= kHiddenRanges[range].to) ++range;
  return range;
}

void count(const ClutterOutcome& outcome, Recall& recall) {
  ++recall.frames;
  recall.found += outcome.found ? 1U : 0U;
}

}  // namespace

bool ClutterOutcome::counts() const {
  return has_object && visible >= kLeastVisible;
}

std::optional<double> Recall::share() const {
  if (frames == 0) return std::nullopt;
  return static_cast<double>(found) / static_cast<double>(frames);
}

void summarise(ObjectClutter& clutter) {
  std::vector<ViewOutcome> poses;
  std::vector<double> times_ms;
  for (const ClutterOutcome& outcome : clutter.outcomes) {
    times_ms.push_back(outcome.elapsed_ms);
    clutter.falsely_named += outcome.falsely_named;
    if (!outcome.has_object) {
      ++clutter.empty;
      clutter.falsely_named_in_empty += outcome.falsely_named;
      continue;
    }
    ++clutter.with_object;
    count(outcome, clutter.by_hidden[range_of(1 - outcome.visible)]);
    if (!outcome.counts()) continue;
    count(outcome, clutter.recall);
    poses.emplace_back().pose = outcome.pose;
  }
  clutter.pose = summarise_poses(poses);
  clutter.median_ms = percentile(times_ms, 0.5);
  clutter.mean_ms = std::accumulate(times_ms.begin(), times_ms.end(), 0.0) /
                    static_cast<double>(std::max<std::size_t>(1, times_ms.size()));
}

std::optional<Error> clutter_fault(const EvaluatedObject& object) {
  if (object.index.vision.sensor != SensorKind::colour)
    return Error{object.index_file +
                 ": of a sensor without colours, and --clutter makes frames in colour; leave "
                 "--clutter out"};
  if (object.scene.studio.projection != Projection::kPerspective)
    return Error{object.scene.file +
                 ": has a camera of parallel rays, and --clutter makes frames in perspective; "
                 "leave --clutter out"};
  return std::nullopt;
}

Result<ObjectClutter> evaluate_clutter(std::span<const EvaluatedObject> objects, std::size_t place,
                                       const EvaluationSettings& settings,
                                       const ClutterSettings& clutter, const FrameTaker& take) {
  constexpr std::size_t kAtOnce = 16;  // frames in memory
  const EvaluatedObject& object = objects[place];
  const Result<LitObject> lit = LitObject::create(object.scene);
  if (!lit) return Error{lit.error()};
  std::vector<ClassIndex> indexes;
  for (const EvaluatedObject& each : objects) indexes.push_back(each.index);
  SizedRecogniser recogniser(indexes, parameters_of(objects, settings));
  ObjectClutter evaluation;
  evaluation.object = object.index.object;
  evaluation.classes = object.index.classes.size();
  evaluation.index_bytes = object.index.file_bytes;
  const auto count = static_cast<std::size_t>(settings.views);
  for (std::size_t first = 0; first < count; first += kAtOnce) {
    std::vector<ClutteredFrame> frames(std::min(kAtOnce, count - first));
    tbb::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t k) {
      const std::size_t number = first + k;
      frames[k] = make_cluttered_frame(object.scene, lit.value(), !is_empty_frame(number), clutter,
                                       dice_of_frame(settings.seed, place, number));
    });
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const ClutteredFrame& frame = frames[k];
      if (take)
        if (const auto error = take(first + k, frame)) return *error;
      recogniser.make_room(frame.width_px, frame.height_px);
      evaluation.outcomes.push_back(
          outcome_of(object, frame, place, recogniser.recognise(frame.view())));
    }
  }
  summarise(evaluation);
  return evaluation;
}

}  // namespace aspect
