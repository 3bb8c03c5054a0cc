// Objects before any background, touching or half hidden: two regions of a frame that look like two
// neighbouring contours of a key view say where the object would be; what else should be seen there
// then says whether it is worth drawing, and the drawing whether it is there.
#pragma once

#include <array>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/left_undone.h"
#include "runtime/recognition/picture_disc.h"
#include "runtime/recognition/pose_finder.h"
#include "runtime/recognition/scene_agreement.h"
#include "runtime/recognition/scene_starts.h"

namespace aspect {

struct SceneObject {
  std::uint16_t index = 0;
  std::uint32_t key_view = 0;  // that it was started from
  float roll_rad = 0;
  RefinedPose refined;
  SceneAgreement agreement;
};

class SceneSearch {
 public:
  static constexpr std::size_t kMostObjects = 24;

  // `in_time`: scenes may have a deadline.
  void prepare(Arena& arena, std::span<const ClassIndex> indexes, bool in_time = false);

  // Those that are there, best first; no two of them in one place or of the same regions. Where
  // the deadline is over before the end, those that the rest could not have taken the place of.
  std::span<const SceneObject> run(const SeenScene& scene);
  const LeftUndone& left_undone() const { return left_undone_; }

 private:
  // The best are kept.
  static constexpr std::size_t kMostDrawn = 256;
  static constexpr int kCorrections = 2;
  // Beyond doubt.
  static constexpr float kSureMargin = 0.46F;
  // A start that explains less of its key view is not drawn.
  static constexpr float kWorth = 0.25F;

  // A start as a pose that was drawn.
  struct Drawn {
    std::uint16_t index = 0;
    std::uint32_t key_view = 0;
    float roll_rad = 0;
    RigidPose pose;
    float margin = 0;                // see SceneAgreement
    std::uint8_t early = kNotEarly;  // that it was refined as, see refine_early()
    bool is_left = false;            // no time was left to refine it
  };
  static constexpr std::uint8_t kNotEarly = 255, kEarlyInVain = 254;

  // With a deadline, starts of all indexes together.
  struct Waiting {
    SceneStart start;
    Drawn drawn;  // roughly, until it is drawn
    enum class State : std::uint8_t { waits, kept, refused } state = State::waits;
  };

  void keep(const Drawn& drawn);
  Drawn laid(const SeenScene& scene, std::size_t index_place, const SceneStart& start,
             int corrections);
  void look_for(const SeenScene& scene, std::size_t index_place);
  bool draw(const SeenScene& scene, Drawn& drawn);
  void draw_starts(const SeenScene& scene, std::size_t index_place);
  PictureDisc place_of(const SeenScene& scene, const SceneObject& object) const;
  PictureDisc place_of(const SeenScene& scene, const Drawn& drawn) const;
  bool is_taken(const SeenScene& scene, const Drawn& drawn) const;
  void refine(const SeenScene& scene, const Drawn& drawn);
  bool compare(const SeenScene& scene, SceneObject& object);
  bool score_again(const SeenScene& scene, SceneObject& object);

  void draw_in_time(const SeenScene& scene);
  void gather_starts(const SeenScene& scene);
  void draw_waiting(const SeenScene& scene, bool taken_places);
  void refine_early(const SeenScene& scene, Drawn& drawn);
  void refine_in_time(const SeenScene& scene, Drawn& drawn);
  void drop_unsettled(const SeenScene& scene);

  std::span<const ClassIndex> indexes_;
  SceneStarts starts_;
  std::array<Drawn, kMostDrawn> drawn_{};
  std::size_t drawn_count_ = 0;
  std::array<SceneObject, kMostObjects> found_{};
  std::size_t found_count_ = 0;
  PoseFinder finder_;
  SeenColours seen_colours_;
  RefinementScratch scratch_;
  Labels of_others_;

  // With a deadline only.
  std::span<Waiting> waiting_;
  std::span<std::uint32_t> waiting_order_;
  std::size_t waiting_count_ = 0;
  std::span<SceneObject> early_;
  LeftUndone left_undone_;
};

}  // namespace aspect
