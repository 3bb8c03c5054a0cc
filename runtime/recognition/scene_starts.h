// Where objects may be before any background: two regions of a frame that look like two
// neighbouring contours of a key view, or one with a clear axis, lay the key view over the frame;
// what else of it finds its colour there says whether that is worth drawing.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/base/deadline.h"
#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/region_pairs.h"
#include "runtime/recognition/region_parts.h"
#include "runtime/vision/planes.h"
#include "runtime/vision/segment.h"

namespace aspect {

// A frame's regions, those of `taken` blobs left out.
struct SeenScene {
  const Planes* colours = nullptr;
  const RegionMap* regions = nullptr;
  std::span<const Contour> contours;
  std::span<const bool> taken;           // by blob
  std::span<const CameraModel> cameras;  // by index
  int width_px = 0, height_px = 0;
  Deadline deadline{};
  std::span<const bool> wanted{};  // by index; empty: all are looked for

  bool wants(std::size_t index) const { return wanted.empty() || wanted[index]; }
};

// A region or pixel whose shares of r, g and b are no farther from a colour of the model may be it.
inline constexpr float kColourReach = 0.1F;

// A key view laid over the frame: a unit of its blob is `scale_px` long.
struct SceneStart {
  float explained = 0;  // share of the key view's area that finds its colour
  float score = 0;      // the same, less where it rests on few contours
  std::uint32_t key_view = 0;
  Point2 centre_px;
  float scale_px = 0, cos = 1, sin = 0;

  // From the blob's centre to a place of the key view, in the frame.
  Point2 laid(const Point2& p) const {
    return {scale_px * (cos * p.x - sin * p.y), scale_px * (sin * p.x + cos * p.y)};
  }
};

class SceneStarts {
 public:
  static constexpr std::size_t kMostStarts = 108;  // of an index

  void prepare(Arena& arena, std::span<const ClassIndex> indexes);

  // Once a frame, before run().
  void see(const SeenScene& scene);

  // The best for the objects of one index; valid until the next run. O(pairs of regions near each
  // other and of a colour of the model, times pairs of contours of about their sizes). Those found
  // by then where the deadline is over.
  std::span<const SceneStart> run(const SeenScene& scene, std::size_t index_place);

 private:
  static constexpr std::size_t kMostRegions = 224, kMostAlone = 12;
  static constexpr std::size_t kMostOfPairs = kMostStarts - kMostAlone;

  struct SeenRegion : RegionPart {
    std::uint64_t colours = 0;  // of the model that it may be, one bit each
  };
  struct List {
    std::array<SceneStart, kMostStarts> starts{};
    std::size_t count = 0, most = kMostOfPairs;
  };

  void see_regions(const SeenScene& scene, const ClassIndex& index);
  void pair_up(const SeenScene& scene, std::size_t index_place);
  void try_pair(const SeenScene& scene, std::size_t index_place, const SeenRegion& first,
                const SeenRegion& second, ColourClass first_colour, ColourClass second_colour);
  void try_alone(const SeenScene& scene, std::size_t index_place, const SeenRegion& region,
                 ColourClass colour);
  static void keep(const ClassIndex& index, const SceneStart& start, List& list);
  void explain(const SeenScene& scene, std::size_t index_place, SceneStart& start) const;

  std::span<const ClassIndex> indexes_;
  std::span<RegionPairs> pairs_;
  RegionParts parts_;
  std::array<SeenRegion, kMostRegions> seen_regions_{};
  std::size_t region_count_ = 0;
  std::array<std::uint64_t, kMaxRegions + 1> colours_of_label_{};
  List of_pairs_, of_regions_;
};

}  // namespace aspect
