#include "runtime/recognition/recogniser.h"

#include <algorithm>

#include "runtime/base/portable_math.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

// Of kMaxShortlist, before second views and what is joined come to them.
constexpr std::size_t kMaxLikely = 192;

// What reaches from border to border both ways is what stands behind.
bool fills_frame(const Box& box, const Frame& frame) {
  constexpr int kNear_px = 2;
  return box.x <= kNear_px && box.x + box.width >= frame.width_px - kNear_px && box.y <= kNear_px &&
         box.y + box.height >= frame.height_px - kNear_px;
}

// A speck of one colour looks like many things, and so does any patch of one beside something that
// takes up much of the picture, a scrap of two that the picture's border cuts off, and what reaches
// from one border to the other where few of its contours have a part in what it may be (`matched`).
bool says_little(const Blob& blob, std::size_t contours, int matched, const Blob& largest,
                 const Frame& frame) {
  constexpr float kLeastArea_px = 1000, kMuch = 0.2F;
  const float frame_px = static_cast<float>(frame.width_px) * static_cast<float>(frame.height_px);
  const bool left = blob.box.x <= 0, top = blob.box.y <= 0,
             right = blob.box.x + blob.box.width >= frame.width_px,
             bottom = blob.box.y + blob.box.height >= frame.height_px;
  const bool is_scrap = contours < 3 && blob.area_px < 2 * kLeastArea_px;
  if (is_scrap && (left || top || right || bottom)) return true;
  constexpr std::size_t kFew = 4;  // of so many contours one
  if (((left && right) || (top && bottom)) && kFew * static_cast<std::size_t>(matched) < contours)
    return true;
  return contours < 2 && (blob.area_px < kLeastArea_px ||
                          (&blob != &largest && largest.area_px > kMuch * frame_px));
}

}  // namespace

CameraModel camera_for(const std::optional<CalibratedCamera>& calibrated, const ClassIndex& index,
                       int width_px, int height_px) {
  const double width = width_px, height = height_px;
  if (calibrated) {
    CameraModel camera = calibrated->model;
    const double scale = calibrated->width_px > 0 ? width / calibrated->width_px : 1;
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

void Recogniser::prepare(Arena& arena, std::span<const ClassIndex> indexes,
                         const RecogniserParameters& parameters, int width_px, int height_px) {
  indexes_ = indexes;
  parameters_ = parameters;
  parameters_.top = std::clamp(parameters.top, 1, kMaxHypotheses);
  has_room_for_one_ = parameters.vision.one_blob;
  vision_.prepare(arena, width_px, height_px, parameters_.vision.sensor);
  if (parameters_.ranking == RecogniserParameters::Ranking::classes)
    class_matcher_.prepare(arena, indexes);
  else
    bounds_.prepare(arena, indexes);
  likely_ = arena.take<LikelyClass>(kMaxLikely);
  candidates_ = arena.take<Hypothesis>(kMaxShortlist);
  const auto top = static_cast<std::size_t>(parameters_.top);
  // What is found anywhere comes on top, until it is known which blobs it explains.
  const std::size_t found =
      (looks_anywhere() ? SceneSearch::kMostObjects : 0) + (tracks() ? Tracker::kMostTracks : 0);
  hypotheses_ = arena.take<Hypothesis>(kMaxBlobs * top + found);
  // A frame has no more external contours than regions, and a hypothesis matches each once.
  contour_matches_ =
      arena.take<ContourMatch>(kMaxRegions * top + SceneSearch::kMostObjects * kMaxClassContours);
  objects_ = arena.take<SeenObject>(kMaxBlobs + found);
  poses_ = arena.take<VerifiedPose>(kMaxBlobs * PoseSearch::kMostPoses + found);
  cameras_ = arena.take<CameraModel>(indexes.size());
  wanted_ = arena.take<bool>(indexes.size());
  view_search_.prepare(indexes);
  pose_search_.prepare(arena, indexes);
  if (looks_anywhere()) scene_search_.prepare(arena, indexes, has_limit());
  if (tracks()) tracker_.prepare(arena, indexes, parameters_.tracking);
}

bool Recogniser::cut_with(const VisionParameters& vision) noexcept {
  if (vision.sensor != parameters_.vision.sensor || (has_room_for_one_ && !vision.one_blob))
    return false;
  parameters_.vision = vision;
  return true;
}

Recognition Recogniser::recognise(const Frame& frame, int steps) noexcept {
  const auto start = std::chrono::steady_clock::now();
  hypothesis_count_ = match_count_ = pose_count_ = 0;
  pose_time_ = {};
  left_undone_ = {};
  if (has_limit()) deadline_ = {parameters_.clock() + parameters_.time_limit, parameters_.clock};
  for (std::size_t i = 0; i < indexes_.size(); ++i)
    cameras_[i] = camera_for(parameters_.camera, indexes_[i], frame.width_px, frame.height_px);
  std::optional<Recognition> followed;
  if (tracks()) {
    tracker_.begin({cameras_, frame.width_px, frame.height_px, std::max(1, steps), deadline_});
    followed = follow(frame);
  }
  Recognition recognition = followed ? *followed : recognise_all(frame);
  recognition.left_undone = left_undone_;
  recognition.elapsed = std::chrono::steady_clock::now() - start;
  return recognition;
}

Recognition Recogniser::recognise_all(const Frame& frame) {
  using Clock = std::chrono::steady_clock;
  Recognition recognition;
  recognition.graph = vision_.run(frame, parameters_.vision);
  const auto seen = Clock::now();
  if (tracks()) begin_track_search(frame);
  std::size_t objects = 0;
  for (; objects < recognition.graph.blobs.size(); ++objects)
    objects_[objects] = recognise_blob(frame, recognition.graph, objects);
  if (looks_anywhere()) objects = search_scene(frame, recognition.graph.contours, objects);
  if (tracks()) objects = join_tracks(objects);
  recognition.objects = objects_.first(objects);
  const auto end = Clock::now();
  const VisionTimes& times = vision_.times();
  recognition.stages = {times.convert,  times.enhance,           times.segment,
                        times.features, end - seen - pose_time_, pose_time_};
  return recognition;
}

bool Recogniser::tracks() const {
  return parameters_.tracking.on && parameters_.poses && !parameters_.vision.one_blob &&
         parameters_.ranking == RecogniserParameters::Ranking::views &&
         parameters_.vision.sensor == SensorKind::colour;
}

SeenObject Recogniser::recognise_blob(const Frame& frame, const ViewGraph& graph,
                                      std::size_t blob_place) {
  const Blob& blob = graph.blobs[blob_place];
  features_of(graph, blob_place, as_seen_);
  const std::size_t count = as_seen_.count;
  if (looks_anywhere() && fills_frame(blob.box, frame))
    return {blob.box, static_cast<int>(count), {Verdict::unknown}, {}, blob_place};
  if (deadline_.is_over()) {
    ++left_undone_.objects;
    return {blob.box, static_cast<int>(count), {Verdict::unknown}, {}, blob_place};
  }
  std::size_t candidates = 0;
  if (parameters_.ranking == RecogniserParameters::Ranking::classes) {
    candidates = shortlist(as_seen_.seen());
  } else {
    candidates = find_views(as_seen_.seen(), candidates_);
    if (parameters_.vision.sensor == SensorKind::colour &&
        join_alike(graph, vision_.regions(), blob_place, parameters_.vision, joined_))
      candidates = add_joined(candidates);
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
    if (hypothesis.score >= parameters_.score_min) report(hypothesis);
  const auto hypotheses = hypotheses_.subspan(first, hypothesis_count_ - first);
  SeenObject object{blob.box, static_cast<int>(count),
                    judge(hypotheses, indexes_, parameters_.confidence_min), hypotheses,
                    blob_place};
  if (object.judgement.verdict != Verdict::none && looks_anywhere() &&
      says_little(blob, count, hypotheses.empty() ? 0 : hypotheses[0].matched, graph.blobs.front(),
                  frame))
    object.judgement.verdict = Verdict::unknown;
  // Something that it was not held against may explain it as well, or better.
  if (deadline_.is_over()) {
    ++left_undone_.objects;
    object.judgement.verdict = Verdict::unknown;
  }
  return object;
}

// Classes in which about as many contours can be matched as in the best one.
std::size_t Recogniser::shortlist(std::span<const ContourFeature> features) {
  int most = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < indexes_.size(); ++i) {
    const ClassIndex& index = indexes_[i];
    class_matcher_.set_contours(index, features);
    for (std::size_t c = 0; c < index.classes.size(); ++c) {
      if (deadline_.is_over()) return count;
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

// Those whose key views may fit best, by bounds, fitted.
std::size_t Recogniser::find_views(std::span<const ContourFeature> features,
                                   std::span<Hypothesis> room) {
  bounds_.set_contours(features);
  // What leaves most of what is seen alone is no fit.
  constexpr float kWorth = 0.6F;
  const float worth = kWorth * bounds_.most_cost();
  const auto less = [](const LikelyClass& a, const LikelyClass& b) {
    if (a.least_cost != b.least_cost) return a.least_cost < b.least_cost;
    return a.index != b.index ? a.index < b.index : a.class_id < b.class_id;
  };
  const std::size_t most = std::min(likely_.size(), room.size());
  const auto begin = likely_.begin();
  std::size_t count = 0;
  const auto end = [&] { return begin + static_cast<std::ptrdiff_t>(count); };
  for (std::size_t i = 0; i < indexes_.size() && !deadline_.is_over(); ++i) {
    // Once there are too many, a heap with the least likely on top.
    const auto bar = [&] { return count < most ? worth : likely_[0].least_cost; };
    if (bounds_.least_cost(i) >= bar()) continue;
    for (std::size_t c = 0; c < indexes_[i].classes.size(); ++c) {
      const LikelyClass likely{bounds_.least_cost(i, c), static_cast<std::uint16_t>(i),
                               static_cast<std::uint16_t>(c)};
      if (likely.least_cost >= bar()) continue;
      if (count == most) {
        std::pop_heap(begin, end(), less);
        likely_[count - 1] = likely;
        std::push_heap(begin, end(), less);
      } else {
        likely_[count++] = likely;
        if (count == most) std::make_heap(begin, end(), less);
      }
    }
  }
  std::sort(begin, end(), less);
  for (std::size_t k = 0; k < count; ++k) {
    Hypothesis& hypothesis = room[k];
    hypothesis = {};
    hypothesis.index = likely_[k].index;
    hypothesis.class_id = likely_[k].class_id;
    hypothesis.least_cost = likely_[k].least_cost;
    hypothesis.view = indexes_[hypothesis.index].classes[hypothesis.class_id].view;
  }
  return view_search_.run(features, room, count, deadline_);
}

// Behind the candidates, those for what light has parted taken together. Of two of one class the
// one that fits worse was only worth a try.
std::size_t Recogniser::add_joined(std::size_t candidates) {
  const auto room = candidates_.subspan(candidates);
  const std::size_t count = find_views(joined_.seen(), room);
  for (Hypothesis& hypothesis : room.first(count)) hypothesis.is_joined = true;
  const auto all = candidates_.first(candidates + count);
  std::sort(all.begin(), all.end(), [](const Hypothesis& a, const Hypothesis& b) {
    if (a.index != b.index) return a.index < b.index;
    if (a.class_id != b.class_id) return a.class_id < b.class_id;
    return a.score != b.score ? a.score > b.score : a.is_joined < b.is_joined;
  });
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k].is_second_view =
        k > 0 && all[k].index == all[k - 1].index && all[k].class_id == all[k - 1].class_id;
  return all.size();
}

void Recogniser::find_poses(std::size_t candidates, std::size_t blob) {
  const auto start = std::chrono::steady_clock::now();
  const SeenBlob seen{&vision_.colours(), &vision_.regions(), blob, cameras_, deadline_};
  pose_count_ += pose_search_.run(candidates_.first(candidates), seen, poses_.subspan(pose_count_));
  pose_time_ += std::chrono::steady_clock::now() - start;
}

bool Recogniser::looks_anywhere() const {
  return parameters_.anywhere && parameters_.poses && !parameters_.vision.one_blob &&
         parameters_.ranking == RecogniserParameters::Ranking::views &&
         parameters_.vision.sensor == SensorKind::colour;
}

// Moves a hypothesis to the result, with the contours that its class matches.
void Recogniser::report(const Hypothesis& hypothesis) {
  const ClassIndex& index = indexes_[hypothesis.index];
  const BlobFeatures& features = hypothesis.is_joined ? joined_ : as_seen_;
  class_matcher_.set_contours(index, features.seen());
  const ClassMatch match = class_matcher_.match(index, hypothesis.class_id, parameters_.matching);
  const std::size_t first = match_count_;
  for (std::size_t i = 0; i < features.count; ++i) {
    if (match.assignment.column_of[i] < 0 || match_count_ == contour_matches_.size()) continue;
    contour_matches_[match_count_++] = {features.contours[i],
                                        static_cast<std::uint16_t>(match.assignment.column_of[i])};
  }
  Hypothesis& reported = hypotheses_[hypothesis_count_++];
  reported = hypothesis;
  reported.matched = match.assignment.matched;
  reported.unmatched = static_cast<int>(features.count) - reported.matched;
  reported.class_score = match.score;
  reported.contours = contour_matches_.subspan(first, match_count_ - first);
}

}  // namespace aspect
