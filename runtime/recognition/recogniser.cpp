#include "runtime/recognition/recogniser.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/portable_math.h"
#include "runtime/recognition/light_estimate.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

// Classes that go on to the fit of their key views.
constexpr std::size_t kMaxCandidates = 512;

// Key views of a class that are followed where they are seen from elsewhere and fit about as well.
constexpr std::size_t kMostViews = 3;

CameraModel camera_of(const RecogniserParameters& parameters, const ClassIndex& index,
                      const Frame& frame) {
  const double width = frame.width_px, height = frame.height_px;
  if (parameters.camera) {
    CameraModel camera = parameters.camera->model;
    const double scale = parameters.camera->width_px > 0 ? width / parameters.camera->width_px : 1;
    camera.fx_px *= scale;
    camera.fy_px *= scale;
    camera.cx_px = (camera.cx_px + 0.5) * scale - 0.5;
    camera.cy_px = (camera.cy_px + 0.5) * scale - 0.5;
    return camera;
  }
  constexpr double kHalf_rad_per_deg = 3.14159265358979323846 / 360;
  const double focal_px =
      width / (2 * portable_tan(static_cast<double>(index.field_of_view_deg) * kHalf_rad_per_deg));
  return {focal_px, focal_px, (width - 1) / 2, (height - 1) / 2};
}

// The view found is the mean of the key views that fit about as well as the best one of their
// class and look from near it.
struct ViewMean {
  static constexpr float kNear_cos = 0.94F;  // 20 degrees
  static constexpr std::size_t kMaxViews = 512;
  std::array<float, kMaxViews> costs{};
  std::array<const KeyView*, kMaxViews> views{};
  std::size_t count = 0;

  void add(const KeyView& view, float cost) {
    if (count == kMaxViews) return;
    costs[count] = cost;
    views[count++] = &view;
  }

  Vector3 about(const KeyView& best, float best_cost) const {
    Vector3 sum{};
    const float scale = 1.0F + 0.5F * best_cost;
    for (std::size_t k = 0; k < count; ++k) {
      const Vector3 &a = best.direction, &b = views[k]->direction;
      if (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < kNear_cos) continue;
      const float weight =
          static_cast<float>(portable_exp(static_cast<double>((best_cost - costs[k]) / scale)));
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += weight * b[axis];
    }
    const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    if (!(length > 0)) return best.direction;
    return {sum[0] / length, sum[1] / length, sum[2] / length};
  }

  // The best of those seen from elsewhere than all of `taken`, null: none.
  const KeyView* elsewhere(std::span<const KeyView* const> taken, float most_cost) const {
    const KeyView* best = nullptr;
    for (std::size_t k = 0; k < count; ++k) {
      const auto is_near = [&](const KeyView* other) {
        const Vector3 &a = other->direction, &b = views[k]->direction;
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] >= kNear_cos;
      };
      if (costs[k] > most_cost || std::any_of(taken.begin(), taken.end(), is_near)) continue;
      best = views[k];
      most_cost = costs[k];
    }
    return best;
  }
};

}  // namespace

void Recogniser::prepare(Arena& arena, std::span<const ClassIndex> indexes,
                         const RecogniserParameters& parameters, int width_px, int height_px) {
  indexes_ = indexes;
  parameters_ = parameters;
  parameters_.top = std::clamp(parameters.top, 1, kMaxHypotheses);
  vision_.prepare(arena, width_px, height_px, parameters_.vision.sensor);
  class_matcher_.prepare(arena, indexes);
  candidates_ = arena.take<Hypothesis>(kMaxCandidates);
  const auto top = static_cast<std::size_t>(parameters_.top);
  hypotheses_ = arena.take<Hypothesis>(kMaxBlobs * top);
  // A frame has no more external contours than regions, and a hypothesis matches each once.
  contour_matches_ = arena.take<ContourMatch>(kMaxRegions * top);
  objects_ = arena.take<SeenObject>(kMaxBlobs);
  poses_ = arena.take<VerifiedPose>(kMaxBlobs * PoseSearch::kMostPoses);
  cameras_ = arena.take<CameraModel>(indexes.size());
  pose_search_.prepare(arena, indexes);
}

Recognition Recogniser::recognise(const Frame& frame) noexcept {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Recognition recognition;
  recognition.graph = vision_.run(frame, parameters_.vision);
  const auto seen = Clock::now();
  hypothesis_count_ = match_count_ = pose_count_ = 0;
  pose_time_ = {};
  for (std::size_t i = 0; i < indexes_.size(); ++i)
    cameras_[i] = camera_of(parameters_, indexes_[i], frame);
  std::size_t objects = 0;
  for (; objects < recognition.graph.blobs.size(); ++objects)
    objects_[objects] = recognise_blob(recognition.graph, objects);
  recognition.objects = objects_.first(objects);
  const auto end = Clock::now();
  const VisionTimes& times = vision_.times();
  recognition.stages = {times.convert,  times.enhance,           times.segment,
                        times.features, end - seen - pose_time_, pose_time_};
  recognition.elapsed = end - start;
  return recognition;
}

SeenObject Recogniser::recognise_blob(const ViewGraph& graph, std::size_t blob_place) {
  const Blob& blob = graph.blobs[blob_place];
  std::array<ContourFeature, kMaxSide> features;
  std::size_t count = 0;
  const auto contours = graph.contours.subspan(static_cast<std::size_t>(blob.first_contour),
                                               static_cast<std::size_t>(blob.contour_count));
  // Holes say nothing that the regions around and in them do not.
  for (const Contour& contour : contours) {
    if (!contour.external || count == kMaxSide) continue;
    contour_of_feature_[count] = static_cast<std::uint16_t>(&contour - graph.contours.data());
    features[count++] = feature_of(contour, blob);
  }
  const auto seen = std::span<const ContourFeature>(features).first(count);
  std::size_t candidates = shortlist(seen);
  if (parameters_.ranking == RecogniserParameters::Ranking::views) {
    const std::size_t classes = candidates;
    candidates = fit_shortlist(seen, classes);
    raise_neighbours(candidates);
    // A model has colours, which other sensors do not see.
    if (parameters_.poses && parameters_.vision.sensor == SensorKind::colour)
      find_poses(candidates, blob_place);
    // Second views were only worth a try.
    const auto all = candidates_.first(candidates);
    candidates = static_cast<std::size_t>(
        std::remove_if(all.begin(), all.end(),
                       [](const Hypothesis& h) { return h.is_second_view && h.pose == nullptr; }) -
        all.begin());
  }
  const auto list = candidates_.first(candidates);
  const std::size_t first = hypothesis_count_;
  const std::size_t reported = std::min({candidates, static_cast<std::size_t>(parameters_.top),
                                         hypotheses_.size() - hypothesis_count_});
  std::partial_sort(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(reported), list.end(),
                    better);
  for (const Hypothesis& hypothesis : list.first(reported))
    if (hypothesis.score >= parameters_.score_min) report(hypothesis, seen);
  const auto hypotheses = hypotheses_.subspan(first, hypothesis_count_ - first);
  return {blob.box, static_cast<int>(count),
          judge(hypotheses, indexes_, parameters_.confidence_min), hypotheses};
}

// Classes in which about as many contours can be matched as in the best one.
std::size_t Recogniser::shortlist(std::span<const ContourFeature> features) {
  int most = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < indexes_.size(); ++i) {
    const ClassIndex& index = indexes_[i];
    class_matcher_.set_contours(index, features);
    for (std::size_t c = 0; c < index.classes.size(); ++c) {
      if (class_matcher_.most_matched(i, c) + parameters_.shortlist_slack < most) continue;
      const ClassMatch match = class_matcher_.match(index, c, parameters_.matching);
      const int matched = match.assignment.matched;
      if (matched == 0 || matched + parameters_.shortlist_slack < most) continue;
      if (matched > most) {
        most = matched;
        const auto weak = [&](const Hypothesis& h) {
          return h.matched + parameters_.shortlist_slack < most;
        };
        const auto kept = candidates_.first(count);
        count =
            static_cast<std::size_t>(std::remove_if(kept.begin(), kept.end(), weak) - kept.begin());
      }
      if (count == candidates_.size()) continue;
      Hypothesis& hypothesis = candidates_[count++];
      hypothesis = {};
      hypothesis.index = static_cast<std::uint16_t>(i);
      hypothesis.class_id = static_cast<std::uint16_t>(c);
      hypothesis.class_score = match.score;
      hypothesis.score = match.score;
      hypothesis.matched = matched;
      hypothesis.unmatched = static_cast<int>(features.size()) - matched;
      hypothesis.view = index.classes[c].view;
    }
  }
  return count;
}

// Scores every candidate by its best key view; adds those that are seen from elsewhere and fit
// about as well, and returns how many there are then.
std::size_t Recogniser::fit_shortlist(std::span<const ContourFeature> features,
                                      std::size_t candidates) {
  view_fitter_.set_contours(features);
  constexpr float kGiveUpFactor = 4, kGiveUpLeast = 8;
  float least_cost = std::numeric_limits<float>::infinity();
  std::size_t count = candidates;
  for (Hypothesis& hypothesis : candidates_.first(candidates)) {
    const ClassIndex& index = indexes_[hypothesis.index];
    const AspectClass& aspect = index.classes[hypothesis.class_id];
    ViewMean mean;
    ViewFit best;
    best.cost = std::numeric_limits<float>::infinity();
    const KeyView* best_view = nullptr;
    for (const KeyView& view : ClassIndex::part(index.key_views, aspect.key_views)) {
      const float give_up = std::max(kGiveUpLeast, kGiveUpFactor * std::min(least_cost, best.cost));
      const ViewFit fit =
          view_fitter_.fit(ClassIndex::part(index.key_contours, view.contours), give_up);
      mean.add(view, fit.cost);
      if (fit.cost >= best.cost) continue;
      best = fit;
      best_view = &view;
    }
    if (best_view == nullptr) {
      hypothesis.score = 0;
      continue;
    }
    least_cost = std::min(least_cost, best.cost);
    const auto start_from = [&](Hypothesis& h, const KeyView& view, const ViewFit& fit) {
      h.score = 1 / (1 + static_cast<double>(fit.cost));
      h.view = mean.about(view, fit.cost);
      h.roll_rad = fit.roll_rad;
      h.start = {view.direction, h.view, fit.roll_rad,
                 estimate_light(features, ClassIndex::part(index.key_contours, view.contours),
                                fit.assignment)};
    };
    start_from(hypothesis, *best_view, best);
    constexpr float kAsWell = 1.5F, kSlack = 0.5F;
    const float most_cost = kAsWell * best.cost + kSlack;
    std::array<const KeyView*, kMostViews> taken{best_view};
    for (std::size_t k = 1; k < kMostViews && count < candidates_.size(); ++k) {
      taken[k] = mean.elsewhere(std::span(taken).first(k), most_cost);
      if (taken[k] == nullptr) break;
      Hypothesis& second = candidates_[count++];
      second = hypothesis;
      second.is_second_view = true;
      start_from(second, *taken[k],
                 view_fitter_.fit(ClassIndex::part(index.key_contours, taken[k]->contours),
                                  2 * most_cost));
    }
  }
  return count;
}

// The best view is found to a few degrees, so that a class seen from near it may be the right one
// however badly its own key views fit, as they do at its border.
void Recogniser::raise_neighbours(std::size_t candidates) {
  constexpr double kShare = 0.5, kReach_rad = 0.05;
  const auto list = candidates_.first(candidates);
  if (list.empty()) return;
  const Hypothesis best = *std::min_element(list.begin(), list.end(), better);
  const ClassIndex& index = indexes_[best.index];
  for (Hypothesis& hypothesis : list) {
    if (hypothesis.index != best.index) continue;
    double nearest = -1;
    const AspectClass& aspect = index.classes[hypothesis.class_id];
    for (const KeyView& view : ClassIndex::part(index.key_views, aspect.key_views)) {
      const Vector3 &a = view.direction, &b = best.view;
      nearest = std::max(nearest, static_cast<double>(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]));
    }
    const double angle = portable_acos(std::clamp(nearest, -1.0, 1.0));
    hypothesis.score =
        std::max(hypothesis.score, kShare * best.score * portable_exp(-angle / kReach_rad));
  }
}

void Recogniser::find_poses(std::size_t candidates, std::size_t blob) {
  const auto start = std::chrono::steady_clock::now();
  const SeenBlob seen{&vision_.colours(), &vision_.regions(), blob, cameras_};
  pose_count_ += pose_search_.run(candidates_.first(candidates), seen, poses_.subspan(pose_count_));
  pose_time_ += std::chrono::steady_clock::now() - start;
}

// Moves a hypothesis to the result, with the contours that its class matches.
void Recogniser::report(const Hypothesis& hypothesis, std::span<const ContourFeature> features) {
  const ClassIndex& index = indexes_[hypothesis.index];
  class_matcher_.set_contours(index, features);
  const ClassMatch match = class_matcher_.match(index, hypothesis.class_id, parameters_.matching);
  const std::size_t first = match_count_;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (match.assignment.column_of[i] < 0 || match_count_ == contour_matches_.size()) continue;
    contour_matches_[match_count_++] = {contour_of_feature_[i],
                                        static_cast<std::uint16_t>(match.assignment.column_of[i])};
  }
  Hypothesis& reported = hypotheses_[hypothesis_count_++];
  reported = hypothesis;
  reported.matched = match.assignment.matched;
  reported.unmatched = static_cast<int>(features.size()) - reported.matched;
  reported.class_score = match.score;
  reported.contours = contour_matches_.subspan(first, match_count_ - first);
}

}  // namespace aspect
