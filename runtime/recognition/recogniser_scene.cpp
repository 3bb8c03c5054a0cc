// The recogniser's search of a frame before any background, and how what it finds comes to what
// stands alone.
#include <algorithm>
#include <limits>

#include "runtime/base/portable_math.h"
#include "runtime/recognition/pose_contours.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {
namespace {

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

std::size_t Recogniser::blob_at(const Box& box) const {
  return vision_.regions().blobs.empty() ? 0 : blob_around(box, vision_.regions());
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

// Where each blob is an object or one of several, only these are looked for once more.
std::span<const bool> Recogniser::wanted_in(std::span<const SeenObject> alone) {
  std::fill(wanted_.begin(), wanted_.end(), false);
  for (const SeenObject& object : alone) {
    if (object.judgement.verdict == Verdict::match) continue;
    if (object.judgement.verdict != Verdict::ambiguous) return {};
    wanted_[object.hypotheses[0].index] = true;
    for (const std::uint8_t place : object.judgement.rival_places())
      if (place < object.hypotheses.size()) wanted_[object.hypotheses[place].index] = true;
  }
  return wanted_;
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
      cameras_,           frame.width_px,     frame.height_px, deadline_,
      wanted_in(alone)};
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

}  // namespace aspect
