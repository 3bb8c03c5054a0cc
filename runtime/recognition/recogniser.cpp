#include "runtime/recognition/recogniser.h"

#include <algorithm>
#include <limits>

#include "runtime/base/portable_math.h"
#include "runtime/recognition/pose_contours.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

// Classes that go on to the fit of their key views.
constexpr std::size_t kMaxCandidates = 512;

// What reaches from border to border both ways is what stands behind.
bool fills_frame(const Box& box, const Frame& frame) {
  constexpr int kNear_px = 2;
  return box.x <= kNear_px && box.x + box.width >= frame.width_px - kNear_px && box.y <= kNear_px &&
         box.y + box.height >= frame.height_px - kNear_px;
}

// A speck of one colour looks like many things, and so does any patch of one beside something that
// takes up much of the picture, and a scrap of two that the picture's border cuts off.
bool says_little(const Blob& blob, std::size_t contours, const Blob& largest, const Frame& frame) {
  constexpr float kLeastArea_px = 1000, kMuch = 0.2F;
  const float frame_px = static_cast<float>(frame.width_px) * static_cast<float>(frame.height_px);
  const bool is_scrap =
      contours < 3 && blob.area_px < 2 * kLeastArea_px &&
      (blob.box.x <= 0 || blob.box.y <= 0 || blob.box.x + blob.box.width >= frame.width_px ||
       blob.box.y + blob.box.height >= frame.height_px);
  if (is_scrap) return true;
  return contours < 2 && (blob.area_px < kLeastArea_px ||
                          (&blob != &largest && largest.area_px > kMuch * frame_px));
}

// The blob that the box's middle lies in or is nearest to.
std::size_t blob_around(const Box& box, const RegionMap& regions) {
  std::size_t nearest = 0;
  int least = std::numeric_limits<int>::max();
  const int x = box.x + box.width / 2, y = box.y + box.height / 2;
  for (std::size_t b = 0; b < regions.blobs.size(); ++b) {
    const Box& other = regions.blobs[b].box;
    const int dx = std::max({other.x - x, x - other.x - other.width, 0}),
              dy = std::max({other.y - y, y - other.y - other.height, 0});
    // The smallest one of several.
    if (std::max(dx, dy) > least) continue;
    least = std::max(dx, dy);
    nearest = b;
  }
  return nearest;
}

float probability_of(const SceneAgreement& agreement) {
  return static_cast<float>(
      1 / (1 + portable_exp(-kLogOddsOfMargin * static_cast<double>(agreement.margin))));
}

// What is most of a blob should have been found as an object that stands alone; where it was not,
// because it is small, blurred or cut, the drawing must agree the better.
bool is_doubtful(const SceneAgreement& agreement, const Box& blob) {
  constexpr float kLeastScore = 0.85F, kLeastOfTwo = 0.9F, kMostOfIt = 0.5F;
  const Box& box = agreement.box;
  const int width = std::min(box.x + box.width, blob.x + blob.width) - std::max(box.x, blob.x),
            height = std::min(box.y + box.height, blob.y + blob.height) - std::max(box.y, blob.y);
  const float least = agreement.colours <= 2 ? kLeastOfTwo : kLeastScore;
  if (agreement.score >= least || width <= 0 || height <= 0) return false;
  const auto shared = static_cast<float>(width * height);
  return shared > kMostOfIt * (static_cast<float>(box.width * box.height) +
                               static_cast<float>(blob.width * blob.height) - shared);
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
  vision_.prepare(arena, width_px, height_px, parameters_.vision.sensor);
  class_matcher_.prepare(arena, indexes);
  candidates_ = arena.take<Hypothesis>(kMaxCandidates);
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
  view_search_.prepare(indexes);
  pose_search_.prepare(arena, indexes);
  if (looks_anywhere()) scene_search_.prepare(arena, indexes, has_limit());
  if (tracks()) tracker_.prepare(arena, indexes, parameters_.tracking);
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

std::size_t Recogniser::blob_at(const Box& box) const {
  return vision_.regions().blobs.empty() ? 0 : blob_around(box, vision_.regions());
}

SeenObject Recogniser::recognise_blob(const Frame& frame, const ViewGraph& graph,
                                      std::size_t blob_place) {
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
  if (looks_anywhere() && fills_frame(blob.box, frame))
    return {blob.box, static_cast<int>(count), {Verdict::unknown}, {}, blob_place};
  if (deadline_.is_over()) {
    ++left_undone_.objects;
    return {blob.box, static_cast<int>(count), {Verdict::unknown}, {}, blob_place};
  }
  std::size_t candidates = shortlist(seen);
  if (parameters_.ranking == RecogniserParameters::Ranking::views) {
    candidates = view_search_.run(seen, candidates_, candidates, deadline_);
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
  SeenObject object{blob.box, static_cast<int>(count),
                    judge(hypotheses, indexes_, parameters_.confidence_min), hypotheses,
                    blob_place};
  if (object.judgement.verdict == Verdict::match && looks_anywhere() &&
      says_little(blob, count, graph.blobs.front(), frame))
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

std::size_t Recogniser::add_found(const SceneObject& found, std::span<const Contour> contours,
                                  std::size_t blob, std::size_t objects) {
  if (objects == objects_.size() || hypothesis_count_ == hypotheses_.size() ||
      pose_count_ == poses_.size())
    return objects;
  objects_[objects] = drawn_match(found, probability_of(found.agreement), blob);
  Hypothesis& hypothesis = hypotheses_[hypothesis_count_ - 1];
  pose_search_.settle(hypothesis, poses_[pose_count_ - 1]);
  const auto matches = contour_matches_.subspan(match_count_);
  hypothesis.contours = matches.first(contours_at_pose(
      indexes_[hypothesis.index], hypothesis.class_id, hypothesis.pose->refined.pose,
      cameras_[hypothesis.index], vision_.regions(), contours, matches));
  match_count_ += hypothesis.contours.size();
  hypothesis.matched = static_cast<int>(hypothesis.contours.size());
  return objects + 1;
}

// What was found by drawing it; its view and class are still to be named.
SeenObject Recogniser::drawn_match(const SceneObject& found, float probability, std::size_t blob) {
  VerifiedPose& pose = poses_[pose_count_++];
  pose.refined = found.refined;
  pose.agreement = {found.agreement.score, found.agreement.score};
  Hypothesis& hypothesis = hypotheses_[hypothesis_count_++];
  hypothesis = {};
  hypothesis.index = found.index;
  hypothesis.score = static_cast<double>(found.agreement.score);
  hypothesis.matched = found.agreement.colours;
  hypothesis.roll_rad = found.roll_rad;
  hypothesis.pose = &pose;
  Judgement judgement;
  judgement.verdict = Verdict::match;
  judgement.probability = probability;
  return {found.agreement.box, found.agreement.colours, judgement,
          hypotheses_.subspan(hypothesis_count_ - 1, 1), blob};
}

// What is found in blobs that are no object takes their place in the list; returns how many objects
// there are then.
std::size_t Recogniser::search_scene(const Frame& frame, std::span<const Contour> contours,
                                     std::size_t objects) {
  const auto alone = objects_.first(objects);
  for (const SeenObject& object : alone)
    taken_[object.blob] = object.judgement.verdict == Verdict::match;
  if (std::all_of(taken_.begin(), taken_.begin() + static_cast<std::ptrdiff_t>(objects),
                  [](bool taken) { return taken; }))
    return objects;
  const auto start = std::chrono::steady_clock::now();
  const SeenScene scene{
      &vision_.colours(), &vision_.regions(), contours,        std::span(taken_).first(objects),
      cameras_,           frame.width_px,     frame.height_px, deadline_};
  std::size_t end = objects;
  for (const SceneObject& found : scene_search_.run(scene)) {
    const std::size_t blob = blob_around(found.agreement.box, vision_.regions());
    if (found.agreement.margin < 0 ||
        static_cast<double>(probability_of(found.agreement)) < parameters_.confidence_min ||
        static_cast<double>(found.agreement.score) < parameters_.score_min ||
        is_doubtful(found.agreement, vision_.regions().blobs[blob].box))
      continue;
    end = add_found(found, contours, blob, end);
  }
  left_undone_.indexes = scene_search_.left_undone().indexes;
  left_undone_.starts = scene_search_.left_undone().starts;
  const std::size_t kept = join_found(objects, end);
  pose_time_ += std::chrono::steady_clock::now() - start;
  return kept;
}

// A blob is what was found in it. Where objects are more than kMaxBlobs, the smallest of those that
// are nothing known are left out.
std::size_t Recogniser::join_found(std::size_t alone_count, std::size_t count) {
  const auto alone = objects_.first(alone_count),
             others = objects_.subspan(alone_count, count - alone_count);
  const auto is_explained = [&](const SeenObject& object) {
    return !taken_[object.blob] &&
           std::any_of(others.begin(), others.end(),
                       [&](const SeenObject& other) { return other.blob == object.blob; });
  };
  auto left = std::remove_if(alone.begin(), alone.end(), is_explained);
  const auto room = [&] { return kMaxBlobs - (left - alone.begin()); };
  for (auto last = left; last != alone.begin() && room() < std::ssize(others);) {
    --last;
    if (!taken_[last->blob]) left = std::move(last + 1, left, last);
  }
  const auto kept = std::copy_n(others.begin(), std::min(room(), std::ssize(others)), left);
  return static_cast<std::size_t>(kept - objects_.begin());
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
