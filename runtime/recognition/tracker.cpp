// An object is looked for from where it would be by the motion between the last two frames; there
// its borders are met as in pose_refinement.h, but by pixels' own colours: no region is grown,
// which is what most of a recognised frame's time goes into. The pose that is found is the result,
// no mean with what was predicted: nothing lags. Where that fails it is looked for from where it
// was, and then from the aspects beside the one that it should show, as the aspect graph has them:
// the same or a neighbour. It is kept as long as its drawing agrees with the picture a little less
// than a new object's must, since that it was there a moment ago speaks for it. Weak where two
// alike objects cross at one turn: they may change numbers.
#include "runtime/recognition/tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/base/portable_math.h"
#include "runtime/recognition/alike_poses.h"
#include "runtime/recognition/picture_disc.h"

namespace aspect {
namespace {

// Drawn finely, but not in every round. Of a clip of 300 frames in which three objects turn, move
// and hide each other: 64 cells in place of 48 take the median error from 0.63 degrees to 0.45; one
// drawing for three rounds takes a frame from 1.0 ms to 0.9, with the same errors. The prediction
// weighed in by covariances took a fifth of the jitter, and the 90th percentile of the errors
// from 1.7 degrees to 4.1: what is seen head-on drifts.
constexpr int kFollowRounds = 4;
constexpr RefinementDetail kFollowDetail{ModelDrawing::kMostCells, 3};
constexpr int kAgreementCells = 32, kGuessCells = 20, kBoxCells = 8;
// Motion is not carried on for longer, and what is lost for so long is forgotten: three seconds of
// most cameras.
constexpr int kMostAhead = 4, kPatience = 90;
// While something is lost every second frame is searched: so it is found within two.
constexpr int kLostEvery = 2;
// How far an object may be from where it is looked for: borders, in shares of half its size; then
// what is no motion any more, in shares of its radius and as a factor of its distance.
constexpr float kLeastFollowReach_px = 4, kFollowReach = 0.1F, kFollowMargin_px = 6;
constexpr double kMostTurn_rad = 0.6, kMostShift = 0.6, kMostNearer = 1.35;
constexpr double kDoubleTurn_rad = 0.5;
// A score so far below what it was lately asks for another start; what it was lately follows a fall
// by such a share a frame, as turning and what passes before the object make it.
constexpr float kWorse = 0.05F, kForgetting = 0.2F;

double turn_angle_rad(const Rotation& turn) {
  return 2 * portable_atan2(norm({turn.x, turn.y, turn.z}), std::abs(turn.w));
}

Rotation share_of(const Rotation& turn, int parts) {
  const double length = norm({turn.x, turn.y, turn.z});
  if (parts == 1 || !(length > 0)) return turn;
  const double towards = (turn.w < 0 ? -1 : 1) / length;
  return turn_about({towards * turn.x, towards * turn.y, towards * turn.z},
                    turn_angle_rad(turn) / parts);
}

// By the number of colours seen, from one on; a new object's are 0.93, 0.68 and 0.58 from two on.
bool is_good(const SceneAgreement& agreement) {
  constexpr std::array<float, 4> kLeast{0.7F, 0.62F, 0.55F, 0.48F};
  constexpr float kLeastInside = 0.3F;
  if (agreement.colours < 1 || agreement.inside < kLeastInside) return false;
  const auto place = std::min<std::size_t>(static_cast<std::size_t>(agreement.colours), 4) - 1;
  return agreement.score >= kLeast[place];
}

Box joined(const Box& a, const Box& b) {
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
          std::max(a.y + a.height, b.y + b.height) - y};
}

bool overlap(const Box& a, const Box& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

int area(const Box& box) {
  return box.width * box.height;
}

bool holds(const Box& box, const Box& part) {
  return area(joined(box, part)) == area(box);
}

}  // namespace

void Tracker::prepare(Arena& arena, std::span<const ClassIndex> indexes,
                      const TrackingParameters& parameters) {
  indexes_ = indexes;
  parameters_ = parameters;
  std::size_t vertices = 0;
  for (const ClassIndex& index : indexes)
    vertices = std::max(vertices, index.model.vertices.size());
  scratch_.drawing.prepare(arena, vertices);
}

void Tracker::begin(const TrackedFrame& frame) {
  if (frame.width_px != frame_.width_px || frame.height_px != frame_.height_px) {
    track_count_ = 0;
    has_searched_ = false;
  }
  frame_ = frame;
  since_search_ += frame.steps;
  has_just_lost_ = false;
  const auto tracks = std::span(tracks_).first(track_count_);
  const auto kept = std::remove_if(tracks.begin(), tracks.end(),
                                   [](const Track& t) { return t.lost_frames > kPatience; });
  track_count_ = static_cast<std::size_t>(kept - tracks.begin());
  for (Track& track : std::span(tracks_).first(track_count_)) {
    track.lost_frames += frame.steps;
    track.is_followed = track.is_claimed = track.is_tried = false;
    track.was_left = std::exchange(track.is_left, false);
    predict(track);
    place_box(track);
  }
  // What hides others comes before them.
  std::sort(tracks_.begin(), tracks_.begin() + static_cast<std::ptrdiff_t>(track_count_),
            [&](const Track& a, const Track& b) {
              const double near = a.predicted(indexes_[a.index].model.centre)[2],
                           far = b.predicted(indexes_[b.index].model.centre)[2];
              return near != far ? near < far : a.number < b.number;
            });
  join_boxes();
}

void Tracker::predict(Track& track) const {
  const Vector3d& model_centre = indexes_[track.index].model.centre;
  const RigidPose& last = track.refined.pose;
  Rotation rotation = last.rotation;
  Vector3d centre = last(model_centre);
  if (track.is_moving)
    for (int k = 0; k < std::min(track.lost_frames, kMostAhead); ++k) {
      rotation = track.turn * rotation;
      centre = centre + track.shift;
    }
  track.predicted = {rotation, centre - rotation(model_centre)};
}

// Around what is drawn; nothing where that is outside of the picture, or was lost long ago.
void Tracker::place_box(Track& track) {
  track.box = {};
  const ClassIndex& index = indexes_[track.index];
  const CameraModel& camera = frame_.cameras[track.index];
  if (track.lost_frames > kMostAhead + frame_.steps ||
      !scratch_.drawing.draw_alone(index.model, track.predicted, camera, frame_.width_px,
                                   frame_.height_px, kBoxCells))
    return;
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const StraightPoint& straight : scratch_.drawing.points()) {
    const Point2d p =
        camera.bent({static_cast<double>(straight.x), static_cast<double>(straight.y)});
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  track.reach_px =
      std::max(kLeastFollowReach_px,
               kFollowReach * static_cast<float>(std::max(right - left, bottom - top)) / 2);
  const double margin = static_cast<double>(track.reach_px + kFollowMargin_px);
  const int x = static_cast<int>(std::max(0.0, left - margin)),
            y = static_cast<int>(std::max(0.0, top - margin));
  const int end_x = static_cast<int>(std::min<double>(frame_.width_px, right + margin)),
            end_y = static_cast<int>(std::min<double>(frame_.height_px, bottom + margin));
  constexpr int kLeastSide_px = 8;
  if (end_x - x >= kLeastSide_px && end_y - y >= kLeastSide_px)
    track.box = {x, y, end_x - x, end_y - y};
}

// Where one box costs no more than two.
void Tracker::join_boxes() {
  box_count_ = 0;
  const auto tracks = std::span(tracks_).first(track_count_);
  for (const Track& track : tracks)
    if (!track.box.empty()) boxes_[box_count_++] = track.box;
  for (std::size_t i = 0; i < box_count_; ++i)
    for (std::size_t j = i + 1; j < box_count_;) {
      const Box both = joined(boxes_[i], boxes_[j]);
      if (area(both) > area(boxes_[i]) + area(boxes_[j])) {
        ++j;
        continue;
      }
      boxes_[i] = both;
      boxes_[j] = boxes_[--box_count_];
      // What did not fit before may do now.
      j = i + 1;
    }
  std::partition(boxes_.begin(), boxes_.begin() + static_cast<std::ptrdiff_t>(box_count_),
                 [&](const Box& box) {
                   return std::any_of(tracks.begin(), tracks.end(), [&](const Track& track) {
                     return track.was_left && !track.box.empty() && holds(box, track.box);
                   });
                 });
  for (Track& track : tracks) {
    const auto boxes = std::span(boxes_).first(box_count_);
    track.box_place = track.box.empty()
                          ? kMostTracks
                          : static_cast<std::size_t>(std::find_if(boxes.begin(), boxes.end(),
                                                                  [&](const Box& box) {
                                                                    return holds(box, track.box);
                                                                  }) -
                                                     boxes.begin());
  }
}

// What is followed already and nearer hides what is behind it.
void Tracker::look(const Track& track) {
  const double depth = track.predicted(indexes_[track.index].model.centre)[2];
  hidden_.start(track.box);
  for (const Track& other : tracks()) {
    if (!other.is_followed || &other == &track || !overlap(other.agreement.box, track.box))
      continue;
    const ObjectModel& model = indexes_[other.index].model;
    const CameraModel& camera = frame_.cameras[other.index];
    if (other.refined.pose(model.centre)[2] < depth &&
        scratch_.drawing.draw_alone(model, other.refined.pose, camera, frame_.width_px,
                                    frame_.height_px, kAgreementCells))
      hidden_.hide(scratch_.drawing, camera);
  }
  seen_.look_at_pixels(*colours_, known_, hidden_.any() ? &hidden_ : nullptr,
                       indexes_[track.index].model, track.light);
}

Tracker::Sight Tracker::sight_from(const Track& track, const RigidPose& start, float reach_px) {
  const ObjectModel& model = indexes_[track.index].model;
  const CameraModel& camera = frame_.cameras[track.index];
  Sight sight;
  sight.refined = refine_pose(model, camera, seen_, track.box, start, kFollowRounds, reach_px,
                              scratch_, Behind::anything, kFollowDetail);
  const RigidPose& pose = sight.refined.pose;
  const double nearer = pose(model.centre)[2] / start(model.centre)[2];
  const PictureDisc from = disc_of(model, start, camera), to = disc_of(model, pose, camera);
  if (angle_between_rad(start.rotation, pose.rotation) > kMostTurn_rad ||
      distance_px(from, to) > kMostShift * from.radius_px || nearer > kMostNearer ||
      nearer * kMostNearer < 1)
    return sight;
  if (!scratch_.drawing.draw_alone(model, pose, camera, frame_.width_px, frame_.height_px,
                                   kAgreementCells))
    return sight;
  sight.agreement =
      scene_agreement(scratch_.drawing, camera, seen_, frame_.width_px, frame_.height_px, 1, {});
  sight.is_good = is_good(sight.agreement);
  return sight;
}

void Tracker::see(Track& track, const Sight& sight) {
  const Vector3d& centre = indexes_[track.index].model.centre;
  const RigidPose &last = track.refined.pose, &pose = sight.refined.pose;
  const int steps = std::max(1, track.lost_frames);
  track.is_moving = steps <= kMostAhead;
  if (track.is_moving) {
    track.shift = (1.0 / steps) * (pose(centre) - last(centre));
    track.turn = share_of(pose.rotation * inverse(last.rotation), steps);
  }
  track.refined = sight.refined;
  track.agreement = sight.agreement;
  track.usual_score =
      std::max(sight.agreement.score,
               track.usual_score + kForgetting * (sight.agreement.score - track.usual_score));
  track.lost_frames = 0;
  ++track.seen_frames;
  track.is_followed = true;
}

bool Tracker::follow(Track& track) {
  track.is_tried = true;
  Sight best = sight_from(track, track.predicted, track.reach_px);
  // As well as lately.
  const auto is_usual = [&] {
    return best.is_good && best.agreement.score > track.usual_score - kWorse;
  };
  const auto try_sight = [&](const Sight& sight) {
    if (sight.is_good && (!best.is_good || sight.agreement.score > best.agreement.score))
      best = sight;
  };
  if (!is_usual() && track.is_moving && !frame_.deadline.is_over())
    try_sight(sight_from(track, track.refined.pose, track.reach_px));
  if (!is_usual() && !frame_.deadline.is_over()) try_sight(sight_of_aspects(track));
  if (!best.is_good) {
    track.is_left = frame_.deadline.is_over();
    return false;
  }
  see(track, best);
  return true;
}

// From the aspects around the one that is expected, each once.
Tracker::Sight Tracker::sight_of_aspects(const Track& track) {
  const ClassIndex& index = indexes_[track.index];
  const CameraModel& camera = frame_.cameras[track.index];
  const RigidPose& pose = track.predicted;
  const Vector3d centre = pose(index.model.centre);
  const Vector3d towards = inverse(pose.rotation)(-1 * centre);
  const Vector3d view = (1 / norm(towards)) * towards;
  const Vector3d side = std::abs(view[0]) < 0.7 ? Vector3d{1, 0, 0} : Vector3d{0, 1, 0};
  const Vector3d across = cross(view, side);
  const Vector3d first = (1 / norm(across)) * across, second = cross(view, first);
  constexpr int kDirections = 8;
  constexpr double kEighth_rad = 3.14159265358979323846 / 4;
  std::array<std::int32_t, 2 * kDirections> classes{};
  std::size_t class_count = 0;
  RigidPose best;
  float best_score = 0;
  for (const double ring_rad : {0.2, 0.4})
    for (int k = 0; k < kDirections; ++k) {
      const double c = portable_cos(k * kEighth_rad), s = portable_sin(k * kEighth_rad);
      const Vector3d direction =
          portable_cos(ring_rad) * view + portable_sin(ring_rad) * (c * first + s * second);
      const std::int32_t seen = index.sphere_map.class_at(direction);
      const auto known = std::span(classes).first(class_count);
      if (std::find(known.begin(), known.end(), seen) != known.end()) continue;
      classes[class_count++] = seen;
      const Rotation rotation = pose.rotation * turn_between(direction, view);
      const RigidPose start{rotation, centre - rotation(index.model.centre)};
      if (!scratch_.drawing.draw_alone(index.model, start, camera, frame_.width_px,
                                       frame_.height_px, kGuessCells))
        continue;
      const float score =
          scene_agreement(scratch_.drawing, camera, seen_, frame_.width_px, frame_.height_px, 1, {})
              .score;
      if (score <= best_score) continue;
      best_score = score;
      best = start;
    }
  if (best_score <= 0) return {};
  return sight_from(track, best, 2 * track.reach_px);
}

void Tracker::follow(const Planes& colours, const Box& known, std::size_t box_place) {
  colours_ = &colours;
  known_ = known;
  follow_in_turn(box_place);
}

// Those of a box, or of all, that are not tried yet; those first that no time was left for before.
void Tracker::follow_in_turn(std::optional<std::size_t> box_place) {
  for (const bool first : {true, false})
    for (Track& track : std::span(tracks_).first(track_count_)) {
      if (track.is_tried || track.box.empty() || track.was_left != first ||
          track.box_place != box_place.value_or(track.box_place))
        continue;
      if (frame_.deadline.is_over()) {
        track.is_left = true;
        continue;
      }
      look(track);
      follow(track);
    }
}

void Tracker::leave(std::size_t box_place) {
  for (Track& track : std::span(tracks_).first(track_count_))
    if (track.box_place == box_place) track.is_left = true;
}

int Tracker::left_count() const {
  return static_cast<int>(std::count_if(tracks().begin(), tracks().end(),
                                        [](const Track& track) { return track.is_left; }));
}

// Two of one object in one pose: one of them follows the other's.
void Tracker::part_doubles() {
  const auto tracks = std::span(tracks_).first(track_count_);
  for (Track& a : tracks)
    for (Track& b : tracks) {
      if (&a == &b || a.index != b.index || !a.is_followed || !b.is_followed) continue;
      const ObjectModel& model = indexes_[a.index].model;
      const CameraModel& camera = frame_.cameras[a.index];
      const RigidPose pose =
          alike_pose_nearest(b.refined.pose, a.refined.pose.rotation, indexes_[a.index]);
      if (!share_place(disc_of(model, a.refined.pose, camera), disc_of(model, pose, camera)) ||
          angle_between_rad(a.refined.pose.rotation, pose.rotation) > kDoubleTurn_rad)
        continue;
      // The one that jumped farther from where it was expected is the guest.
      const auto jump = [&](const Track& t) {
        return distance_px(disc_of(model, t.predicted, camera),
                           disc_of(model, t.refined.pose, camera));
      };
      const bool a_is_known = a.seen_frames >= Track::kKnown,
                 b_is_known = b.seen_frames >= Track::kKnown;
      Track& guest = a_is_known != b_is_known ? (a_is_known ? b : a) : jump(a) > jump(b) ? a : b;
      guest.is_followed = false;
      guest.lost_frames = frame_.steps;
    }
}

void Tracker::finish() {
  part_doubles();
  const auto is_just_lost = [&](const Track& track) {
    return !track.is_followed && !track.is_left &&
           (track.lost_frames <= frame_.steps || track.was_left);
  };
  has_just_lost_ = has_just_lost_ || std::any_of(tracks().begin(), tracks().end(), is_just_lost);
}

bool Tracker::is_search_due() const {
  const auto is_lost = [&](const Track& track) {
    return track.lost_frames > frame_.steps && !track.was_left;
  };
  const bool any_lost = std::any_of(tracks().begin(), tracks().end(), is_lost);
  return !has_searched_ || since_search_ >= parameters_.search_every || has_just_lost_ ||
         (any_lost && since_search_ >= kLostEvery);
}

}  // namespace aspect
