#include "runtime/c_interface/plain_results.h"

#include <algorithm>
#include <chrono>

#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

aspect_box plain(const Box& box) {
  return {box.x, box.y, box.width, box.height};
}

aspect_pose plain(const RefinedPose& refined) {
  const Rotation& q = refined.pose.rotation;
  aspect_pose pose{{q.w, q.x, q.y, q.z}, {}, static_cast<double>(refined.reprojection_px), {}};
  std::copy(refined.pose.translation.begin(), refined.pose.translation.end(), pose.translation);
  std::copy(refined.covariance.begin(), refined.covariance.end(), pose.covariance);
  return pose;
}

aspect_verdict plain(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return ASPECT_NO_VERDICT;
    case Verdict::match:
      return ASPECT_MATCH;
    case Verdict::ambiguous:
      return ASPECT_AMBIGUOUS;
    case Verdict::unknown:
      break;
  }
  return ASPECT_UNKNOWN;
}

}  // namespace

void PlainResults::make_room(std::size_t indexes, int top) {
  // As the recogniser's own lists are, see Recogniser::prepare.
  constexpr std::size_t kMostFound = SceneSearch::kMostObjects + Tracker::kMostTracks;
  const auto each = static_cast<std::size_t>(std::clamp(top, 1, kMaxHypotheses));
  objects_.reserve(kMaxBlobs + kMostFound);
  hypotheses_.reserve(kMaxBlobs * each + kMostFound);
  poses_.reserve(kMaxBlobs * PoseSearch::kMostPoses + kMostFound);
  matches_.reserve(kMaxRegions * each + SceneSearch::kMostObjects * kMaxClassContours);
  contours_.reserve(std::size_t{2} * kMaxRegions);
  cameras_.reserve(indexes);
}

aspect_recognition PlainResults::of(const Recognition& recognition,
                                    std::span<const ClassIndex> indexes,
                                    std::span<const CameraModel> cameras) noexcept {
  objects_.clear();
  hypotheses_.clear();
  poses_.clear();
  matches_.clear();
  contours_.clear();
  cameras_.clear();
  for (const Contour& contour : recognition.graph.contours) add(contour);
  for (const SeenObject& object : recognition.objects) add(object, indexes);
  for (const CameraModel& c : cameras)
    cameras_.push_back({c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.k2, c.p1, c.p2, c.k3});

  const LeftUndone& left = recognition.left_undone;
  aspect_recognition plain{};
  plain.objects = objects_.data();
  plain.object_count = objects_.size();
  plain.contours = contours_.data();
  plain.contour_count = contours_.size();
  plain.cameras = cameras_.data();
  plain.camera_count = cameras_.size();
  plain.dropped_regions = recognition.graph.dropped_regions;
  plain.elapsed_ms = std::chrono::duration<double, std::milli>(recognition.elapsed).count();
  plain.left_undone = {left.objects, left.indexes, left.starts, left.tracks, left.searches};
  return plain;
}

void PlainResults::add(const SeenObject& object, std::span<const ClassIndex> indexes) {
  // Pointers into lists whose room is never outgrown stay good.
  const std::size_t first = hypotheses_.size();
  for (const Hypothesis& hypothesis : object.hypotheses) add(hypothesis, indexes);
  const std::span<const std::uint8_t> rivals = object.judgement.rival_places();
  objects_.push_back({plain(object.box), object.regions, plain(object.judgement.verdict),
                      static_cast<double>(object.judgement.probability), hypotheses_.data() + first,
                      hypotheses_.size() - first, rivals.data(), rivals.size(), object.track});
}

void PlainResults::add(const Hypothesis& hypothesis, std::span<const ClassIndex> indexes) {
  const std::size_t first = matches_.size();
  for (const ContourMatch& match : hypothesis.contours)
    matches_.push_back({match.contour, match.name});
  const aspect_pose* pose = nullptr;
  if (hypothesis.pose != nullptr) pose = &poses_.emplace_back(plain(hypothesis.pose->refined));
  aspect_hypothesis plain{};
  plain.object = indexes[hypothesis.index].object.c_str();
  plain.known_object = hypothesis.index;
  plain.class_id = hypothesis.class_id;
  plain.score = hypothesis.score;
  plain.matched = hypothesis.matched;
  plain.unmatched = hypothesis.unmatched;
  std::copy(hypothesis.view.begin(), hypothesis.view.end(), plain.view);
  plain.pose = pose;
  plain.contours = matches_.data() + first;
  plain.contour_count = matches_.size() - first;
  hypotheses_.push_back(plain);
}

void PlainResults::add(const Contour& contour) {
  const auto& rgb = contour.mean_rgb;
  contours_.push_back({plain(contour.box),
                       contour.centre_px.x,
                       contour.centre_px.y,
                       contour.area_px,
                       {rgb[0], rgb[1], rgb[2]},
                       contour.external ? 0 : 1,
                       contour.start_x,
                       contour.start_y,
                       contour.chain.data(),
                       contour.chain.size()});
}

}  // namespace aspect
