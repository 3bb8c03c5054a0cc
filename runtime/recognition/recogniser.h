// The half of Aspect that recognises: a frame in, the objects seen in it out, each with a ranked
// list of hypotheses which object, which aspect and from where (thesis 3.5).
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/base/arena.h"
#include "runtime/base/deadline.h"
#include "runtime/recognition/blob_features.h"
#include "runtime/recognition/class_bounds.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/class_match.h"
#include "runtime/recognition/hypothesis.h"
#include "runtime/recognition/left_undone.h"
#include "runtime/recognition/pose_search.h"
#include "runtime/recognition/scene_search.h"
#include "runtime/recognition/tracker.h"
#include "runtime/recognition/verdict.h"
#include "runtime/recognition/view_search.h"
#include "runtime/vision/vision.h"

namespace aspect {

// A camera, and the size of the pictures that it was calibrated for; others are taken as scaled.
struct CalibratedCamera {
  CameraModel model;
  int width_px = 0;
};

// For frames of that size; without a calibration: the index's field of view, about the picture's
// centre.
CameraModel camera_for(const std::optional<CalibratedCamera>& calibrated, const ClassIndex& index,
                       int width_px, int height_px);

struct RecogniserParameters {
  VisionParameters vision;

  // Nothing: each index's own field of view, with the picture's centre as principal point.
  std::optional<CalibratedCamera> camera;

  // How a frame's contours are matched with a class's: as many as possible, or with the largest
  // sum of scores among those (thesis 3.5.1).
  Matching matching = Matching::weighted;

  // views: classes are ranked by their best key view, colour, size, shape and place of every
  // contour compared. classes: by the thesis's score alone.
  enum class Ranking : std::uint8_t { views, classes } ranking = Ranking::views;

  // Hypotheses reported for each object seen, 1 to kMaxHypotheses.
  int top = 10;

  // Hypotheses with a lower score are not reported; 0 reports all. Typical 0.2 with ranking by
  // views, whose scores lie between 0 and 1.
  double score_min = 0;

  // Probability from which an object is a match.
  double confidence_min = 0.5;

  // Poses are found for the best hypotheses; not with ranking by classes.
  bool poses = true;

  // What is not explained as an object that stands alone is searched for objects before any
  // background, touching or half hidden; needs poses.
  bool anywhere = true;

  // Contours a class may match fewer than the best class and still be on the shortlist, typical 1;
  // with ranking by classes only.
  int shortlist_slack = 1;

  // From frame to frame; needs poses.
  TrackingParameters tracking;

  // Of a frame, from the call on; 0: as long as it takes. When it is over, what has been found is
  // the result, and what was left undone is said. Seeing, up to the regions' contours, is not cut
  // short, and what is begun is ended: up to a millisecond more on a workstation. With a limit the
  // search before any background takes 15 KiB more for each index.
  std::chrono::nanoseconds time_limit{};
  // By this clock, which must not go back: another one for tests.
  Deadline::Clock clock = std::chrono::steady_clock::now;
};

struct SeenObject {
  Box box;
  int regions = 0;
  Judgement judgement;
  std::span<const Hypothesis> hypotheses;  // best first
  std::size_t blob = 0;                    // of the graph: that it is, or that its middle lies in
  std::uint32_t track = 0;                 // its number from frame to frame; 0: none
};

struct StageTimes {
  std::chrono::nanoseconds convert{}, enhance{}, segment{}, features{}, match{}, pose{};
};

struct Recognition {
  ViewGraph graph;  // what was seen
  // Those alone, largest first, then the others, best first, and then those that are followed. Of a
  // frame that was not searched these only, and no graph.
  std::span<const SeenObject> objects;
  StageTimes stages;
  std::chrono::nanoseconds elapsed{};
  LeftUndone left_undone;
};

inline constexpr int kMaxHypotheses = 64;
// Classes that go on to the fit of their key views, or are ranked.
inline constexpr std::size_t kMaxShortlist = 512;

class Recogniser {
 public:
  // `indexes` must outlive the recogniser. Takes all memory for frames of up to width x height
  // from the arena; an arena without storage only counts the bytes.
  void prepare(Arena& arena, std::span<const ClassIndex> indexes,
               const RecogniserParameters& parameters, int width_px, int height_px);

  // Allocates nothing. The result lives until the next call. A frame of another sensor than
  // parameters.vision.sensor (see gives) is seen as empty: refuse it before. `steps`: frames since
  // the last call, for tracking; 2 where one was not seen.
  Recognition recognise(const Frame& frame, int steps = 1) noexcept;

  // From the next frame on pictures are cut so. Allocates nothing, and leaves what is followed as
  // it is. False, and nothing has changed, where that needs other memory: for another sensor, or
  // for more than the one blob that was prepared for.
  [[nodiscard]] bool cut_with(const VisionParameters& vision) noexcept;

  const RegionMap& regions() const { return vision_.regions(); }
  // Of the last frame: its pixels, and the camera that each index's objects were looked for with.
  const Planes& colours() const { return vision_.colours(); }
  std::span<const CameraModel> cameras() const { return cameras_; }

 private:
  Recognition recognise_all(const Frame& frame);
  bool tracks() const;
  bool has_limit() const { return parameters_.time_limit.count() > 0; }
  std::optional<Recognition> follow(const Frame& frame);
  void begin_track_search(const Frame& frame);
  std::size_t join_tracks(std::size_t objects);
  std::size_t add_tracks(std::size_t objects);
  SeenObject seen_track(const Track& track);
  SeenObject drawn_match(const SceneObject& found, float probability, std::size_t blob);
  std::size_t blob_at(const Box& box) const;
  SeenObject recognise_blob(const Frame& frame, const ViewGraph& graph, std::size_t blob_place);
  std::size_t shortlist(std::span<const ContourFeature> features);
  std::size_t find_views(std::span<const ContourFeature> features, std::span<Hypothesis> room);
  std::size_t add_joined(std::size_t candidates);
  void find_poses(std::size_t candidates, std::size_t blob);
  bool looks_anywhere() const;
  std::size_t add_found(const SceneObject& found, std::span<const Contour> contours,
                        std::size_t blob, std::size_t objects);
  std::span<const bool> wanted_in(std::span<const SeenObject> alone);
  std::size_t search_scene(const Frame& frame, std::span<const Contour> contours,
                           std::size_t objects);
  std::size_t join_found(std::size_t alone_count, std::size_t count);
  void report(const Hypothesis& hypothesis);

  std::span<const ClassIndex> indexes_;
  RecogniserParameters parameters_;
  bool has_room_for_one_ = false;  // blob only
  Vision vision_;
  // A class, and what its key views cost at the very least.
  struct LikelyClass {
    float least_cost = 0;
    std::uint16_t index = 0, class_id = 0;
  };
  ClassBounds bounds_;
  std::span<LikelyClass> likely_;
  std::span<Hypothesis> candidates_;
  std::span<Hypothesis> hypotheses_;
  std::span<ContourMatch> contour_matches_;
  std::span<SeenObject> objects_;
  BlobFeatures as_seen_, joined_;  // of the blob at hand
  std::size_t hypothesis_count_ = 0, match_count_ = 0;
  ClassMatcher class_matcher_;
  ViewSearch view_search_;
  PoseSearch pose_search_;
  SceneSearch scene_search_;
  Tracker tracker_;
  std::array<bool, kMaxBlobs> taken_{};
  std::span<bool> wanted_;          // by index
  std::span<CameraModel> cameras_;  // of this frame, for each index
  std::span<VerifiedPose> poses_;
  std::size_t pose_count_ = 0;
  std::chrono::nanoseconds pose_time_{};
  Deadline deadline_;  // of this frame
  LeftUndone left_undone_;
};

}  // namespace aspect
