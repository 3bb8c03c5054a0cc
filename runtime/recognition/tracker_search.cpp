// What a search of all of a frame has recognised is told apart: what is followed already, what was
// lost, what is new.
#include <algorithm>

#include "runtime/recognition/alike_poses.h"
#include "runtime/recognition/picture_disc.h"
#include "runtime/recognition/tracker.h"

namespace aspect {
namespace {

// Poses are one where they are turned by less against each other; farther apart the one that
// explains the picture better counts, by more where no object turns so far from frame to frame.
constexpr double kSamePose_rad = 0.05, kFarTurn_rad = 0.6;
constexpr float kBetter = 0.02F, kTurnedBetter = 0.06F, kOtherBetter = 0.1F, kNear_px = 4;

}  // namespace

void Tracker::begin_search(const Planes& colours, const Box& known) {
  colours_ = &colours;
  known_ = known;
  since_search_ = 0;
  has_searched_ = true;
  follow_in_turn(std::nullopt);
  part_doubles();
}

void Tracker::finish_search() {
  const auto is_nothing = [](const Track& track) {
    return track.seen_frames < Track::kKnown && !track.is_claimed && !track.is_left &&
           !(track.is_followed && track.agreement.margin >= 0);
  };
  const auto tracks = std::span(tracks_).first(track_count_);
  track_count_ = static_cast<std::size_t>(std::remove_if(tracks.begin(), tracks.end(), is_nothing) -
                                          tracks.begin());
}

Track* Tracker::followed_at(const RecognisedObject& object, bool same_index) {
  const PictureDisc place =
      disc_of(indexes_[object.index].model, object.refined.pose, frame_.cameras[object.index]);
  Track* nearest = nullptr;
  double least = 0;
  for (Track& track : std::span(tracks_).first(track_count_)) {
    if (!track.is_followed || (same_index && track.is_claimed) ||
        (track.index == object.index) != same_index)
      continue;
    const PictureDisc other =
        disc_of(indexes_[track.index].model, track.refined.pose, frame_.cameras[track.index]);
    const double distance = distance_px(place, other);
    if (!share_place(place, other) || (nearest != nullptr && distance >= least)) continue;
    nearest = &track;
    least = distance;
  }
  return nearest;
}

// The one that was lost nearest to the place; from farther away only where no other is lost.
Track* Tracker::lost_one(const RecognisedObject& object) {
  const ObjectModel& model = indexes_[object.index].model;
  const CameraModel& camera = frame_.cameras[object.index];
  const PictureDisc place = disc_of(model, object.refined.pose, camera);
  Track* nearest = nullptr;
  double least = 0, reach = 0;
  int lost = 0;
  for (Track& track : std::span(tracks_).first(track_count_)) {
    if (track.index != object.index || track.is_followed || track.is_claimed) continue;
    ++lost;
    const PictureDisc other = disc_of(model, track.predicted, camera);
    const double distance = distance_px(place, other);
    if (nearest != nullptr && distance >= least) continue;
    nearest = &track;
    least = distance;
    // A quarter of its radius a frame.
    reach = other.radius_px * (1 + 0.25 * track.lost_frames);
  }
  return lost == 1 || least <= reach ? nearest : nullptr;
}

Tracker::Claimed Tracker::claim(const RecognisedObject& object) {
  const ClassIndex& index = indexes_[object.index];
  if (Track* track = followed_at(object, true)) {
    track->is_claimed = true;
    track->probability = object.probability;
    const RigidPose pose =
        alike_pose_nearest(object.refined.pose, track->refined.pose.rotation, index);
    const double turn_rad = angle_between_rad(pose.rotation, track->refined.pose.rotation);
    if (turn_rad > kSamePose_rad && !frame_.deadline.is_over()) {
      look(*track);
      const Sight sight = sight_from(*track, pose, kNear_px);
      // No object turns so far from one frame to the next unless it was seen wrongly before.
      const float better = turn_rad > kFarTurn_rad ? kTurnedBetter : kBetter;
      if (sight.is_good && sight.agreement.score > track->agreement.score + better) {
        see(*track, sight);
        track->is_moving = false;
      }
    }
    return {Claim::followed, track};
  }
  if (Track* other = followed_at(object, false);
      other != nullptr && object.agreement.score < other->agreement.score + kOtherBetter)
    return {Claim::refused, other};
  Track* track = lost_one(object);
  if (track == nullptr) {
    if (track_count_ == kMostTracks) return {Claim::refused, nullptr};
    track = &tracks_[track_count_++];
    *track = {};
    track->number = ++last_number_;
    track->index = object.index;
    track->refined = object.refined;
  }
  Sight sight{object.refined, object.agreement, true};
  sight.refined.pose = alike_pose_nearest(sight.refined.pose, track->predicted.rotation, index);
  // Far from where it was expected it was set down, or seen wrongly before: that is no motion.
  const CameraModel& camera = frame_.cameras[object.index];
  const bool goes_on =
      track->lost_frames > 0 &&
      share_place(disc_of(index.model, track->predicted, camera),
                  disc_of(index.model, sight.refined.pose, camera)) &&
      angle_between_rad(track->predicted.rotation, sight.refined.pose.rotation) < kFarTurn_rad;
  see(*track, sight);
  if (!goes_on) track->is_moving = false;
  track->light = object.light;
  track->probability = object.probability;
  track->is_claimed = track->is_tried = true;
  return {Claim::found, track};
}

}  // namespace aspect
