// Objects before any background, touching or half hidden: two regions of a frame that look like two
// neighbouring contours of a key view say where the object would be; what else should be seen there
// then says whether it is worth drawing, and the drawing whether it is there.
#pragma once

#include <array>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/class_index.h"
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

  void prepare(Arena& arena, std::span<const ClassIndex> indexes);

  // Those that are there, best first; no two of them in one place or of the same regions.
  std::span<const SceneObject> run(const SeenScene& scene);

 private:
  // The best are kept.
  static constexpr std::size_t kMostDrawn = 256;

  // A start as a pose that was drawn.
  struct Drawn {
    std::uint16_t index = 0;
    std::uint32_t key_view = 0;
    float roll_rad = 0;
    RigidPose pose;
    float margin = 0;  // see SceneAgreement
  };

  void keep(const Drawn& drawn);
  void draw_starts(const SeenScene& scene, std::size_t index_place);
  bool is_taken(const SeenScene& scene, const Drawn& drawn) const;
  void refine(const SeenScene& scene, const Drawn& drawn);
  bool score_again(const SeenScene& scene, SceneObject& object);

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
};

}  // namespace aspect
