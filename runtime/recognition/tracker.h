// Objects followed from frame to frame: each is looked for where its motion says it will be, and
// keeps its number.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/base/deadline.h"
#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/pose_refinement.h"
#include "runtime/recognition/scene_agreement.h"

namespace aspect {

inline constexpr int kMostSearchEvery = 1000;

struct TrackingParameters {
  // Off: every frame is recognised for itself.
  bool on = false;

  // All of every n-th frame is searched for objects that are not followed yet; 1: every frame.
  // Typical 10; higher costs less and sees new objects later. What was lost is searched for at
  // once.
  int search_every = 10;
};

struct TrackedFrame {
  std::span<const CameraModel> cameras;  // by index
  int width_px = 0, height_px = 0;
  int steps = 1;  // since the frame before: 2 where one between them was not seen
  Deadline deadline{};
};

struct Track {
  // Seen in fewer frames, it was nothing where it is lost and a search does not find it.
  static constexpr int kKnown = 5;

  std::uint32_t number = 0;  // from 1 on, never given twice
  std::uint16_t index = 0;
  RefinedPose refined;       // where it was seen last
  SceneAgreement agreement;  // with the picture, there
  LightGain light;
  float probability = 0;     // that it is this object: as it was recognised last
  int lost_frames = 0;       // since it was seen
  int seen_frames = 0;       // so often; few: it may be nothing
  float usual_score = 0;     // that its agreement had lately
  bool is_followed = false;  // seen in this frame where it was looked for
  bool is_claimed = false;   // and recognised there
  bool is_left = false;      // no time was left to look for it
  bool was_left = false;     // in the frame before

  // From frame to frame: about and of its centre, in the camera's frame.
  Rotation turn;
  Vector3d shift{};
  bool is_moving = false;  // that is known

  RigidPose predicted;  // in this frame
  Box box;              // that it is looked for in; empty: it is not
  float reach_px = 0;
  std::size_t box_place = 0;  // that its box is joined to
  bool is_tried = false;
};

// What a search of the frame has recognised.
struct RecognisedObject {
  std::uint16_t index = 0;
  RefinedPose refined;
  SceneAgreement agreement;  // only its box counts
  LightGain light;
  float probability = 0;
};

// In each frame: begin(), follow() with each of the boxes() seen, finish(); then, where
// is_search_due(), begin_search() and claim() with everything that the search has recognised.
class Tracker {
 public:
  static constexpr std::size_t kMostTracks = 32;

  // The drawing's memory; tracks are the object's own.
  void prepare(Arena& arena, std::span<const ClassIndex> indexes,
               const TrackingParameters& parameters);

  // Predicts where objects are. Everything is forgotten, but no number given again, where frames
  // have another size than before.
  void begin(const TrackedFrame& frame);

  // Parts of the frame to be looked at, joined where they overlap much.
  std::span<const Box> boxes() const { return std::span(boxes_).first(box_count_); }

  // Looks for the objects whose box this is.
  void follow(const Planes& colours, const Box& known, std::size_t box_place);
  // There is no time to: they are not lost for that, and come first in the next frame.
  void leave(std::size_t box_place);
  int left_count() const;

  // After the last box: which ones are lost.
  void finish();
  bool is_search_due() const;

  // A search sees all of the frame: follows those as well that no box was looked at for.
  void begin_search(const Planes& colours, const Box& known);

  enum class Claim : std::uint8_t {
    followed,  // the track knows better where it is
    found,     // lost before, or new
    refused,   // another object is followed in this place, or there are too many
  };
  struct Claimed {
    Claim claim = Claim::refused;
    const Track* track = nullptr;
  };
  Claimed claim(const RecognisedObject& object);

  // What was new in a search before and is not found again is nothing.
  void finish_search();

  std::span<const Track> tracks() const { return std::span(tracks_).first(track_count_); }

 private:
  struct Sight {
    RefinedPose refined;
    SceneAgreement agreement;
    bool is_good = false;
  };
  void predict(Track& track) const;
  void place_box(Track& track);
  void join_boxes();
  void look(const Track& track);
  Sight sight_from(const Track& track, const RigidPose& start, float reach_px);
  void follow_in_turn(std::optional<std::size_t> box_place);
  bool follow(Track& track);
  Sight sight_of_aspects(const Track& track);
  void see(Track& track, const Sight& sight);
  void part_doubles();
  Track* followed_at(const RecognisedObject& object, bool same_index);
  Track* lost_one(const RecognisedObject& object);

  std::span<const ClassIndex> indexes_;
  TrackingParameters parameters_;
  TrackedFrame frame_;
  std::array<Track, kMostTracks> tracks_{};
  std::size_t track_count_ = 0;
  std::array<Box, kMostTracks> boxes_{};
  std::size_t box_count_ = 0;
  std::uint32_t last_number_ = 0;
  int since_search_ = 0;
  bool has_searched_ = false, has_just_lost_ = false;
  const Planes* colours_ = nullptr;
  Box known_;
  HiddenPart hidden_;
  SeenColours seen_;
  RefinementScratch scratch_;
};

}  // namespace aspect
