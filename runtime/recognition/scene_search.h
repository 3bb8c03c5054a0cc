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
#include "runtime/recognition/region_pairs.h"
#include "runtime/recognition/scene_agreement.h"

namespace aspect {

// A frame's regions, those of `taken` blobs left out.
struct SeenScene {
  const Planes* colours = nullptr;
  const RegionMap* regions = nullptr;
  std::span<const bool> taken;           // by blob
  std::span<const CameraModel> cameras;  // by index
  int width_px = 0, height_px = 0;
};

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

  // Best first; no two of them in one place.
  std::span<const SceneObject> run(const SeenScene& scene);

 private:
  // Of each, the largest and the best are kept.
  static constexpr std::size_t kMostRegions = 160, kMostStarts = 48, kMostDrawn = 256;

  struct SeenRegion {
    Point2 centre_px;
    float area_px = 0;
    Moments moments;
    std::uint64_t colours = 0;  // of the model that it may be, one bit each
  };
  // A key view laid over the frame: a unit of its blob is `scale_px` long.
  struct Start {
    float score = 0;
    std::uint32_t key_view = 0;
    Point2 centre_px;
    float scale_px = 0, cos = 1, sin = 0;

    // From the blob's centre to a place of the key view, in the frame.
    Point2 laid(const Point2& p) const {
      return {scale_px * (cos * p.x - sin * p.y), scale_px * (sin * p.x + cos * p.y)};
    }
  };
  struct Starts {
    std::array<Start, kMostStarts> list{};
    std::size_t count = 0, most = kMostStarts;

    std::span<const Start> all() const { return std::span(list).first(count); }
  };
  // The same as a pose that was drawn.
  struct Drawn {
    std::uint16_t index = 0;
    std::uint32_t key_view = 0;
    float roll_rad = 0;
    RigidPose pose;
    float margin = 0;  // see SceneAgreement
  };

  void see_regions(const SeenScene& scene, const ClassIndex& index);
  void pair_up(const SeenScene& scene, std::size_t index_place);
  void try_pair(const SeenScene& scene, std::size_t index_place, const SeenRegion& first,
                const SeenRegion& second, ColourClass first_colour, ColourClass second_colour);
  void try_alone(const SeenScene& scene, std::size_t index_place, const SeenRegion& region,
                 ColourClass colour);
  static void keep(const ClassIndex& index, const Start& start, Starts& starts);
  float explained(const SeenScene& scene, std::size_t index_place, const Start& start) const;
  void keep(const Drawn& drawn);
  void draw_starts(const SeenScene& scene, std::size_t index_place);
  bool is_taken(const SeenScene& scene, const Drawn& drawn) const;
  void refine(const SeenScene& scene, const Drawn& drawn);

  std::span<const ClassIndex> indexes_;
  std::span<RegionPairs> pairs_;
  std::array<SeenRegion, kMostRegions> seen_regions_{};
  std::size_t region_count_ = 0;
  std::array<std::uint64_t, kMaxRegions + 1> colours_of_label_{};
  Starts of_pairs_, of_regions_;
  std::array<Drawn, kMostDrawn> drawn_{};
  std::size_t drawn_count_ = 0;
  std::array<SceneObject, kMostObjects> found_{};
  std::size_t found_count_ = 0;
  PoseFinder finder_;
  SeenColours seen_colours_;
  RefinementScratch scratch_;
};

}  // namespace aspect
