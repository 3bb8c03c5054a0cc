// Stage "segment", steps 3 and 4 of the thesis's segmentation (3.2.2): connected regions of equal
// colour ratio under 4-connectedness, without very small ones and filaments; and the blobs, the
// connected pieces of foreground that they belong to.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/components.h"
#include "runtime/vision/pixel_sums.h"
#include "runtime/vision/region_growth.h"
#include "runtime/vision/share_rows.h"
#include "runtime/vision/view_graph.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

struct Region {
  PixelSums sums;
  std::array<float, 3> mean_rgb{};  // of its core, away from blurred edges
  Box box;
  int blob = 0;
};

struct RegionMap {
  std::span<std::uint16_t> labels;  // region + 1 of each pixel, 0: none; valid within `active`
  int stride_px = 0;
  Box active;
  std::span<const Run> runs;        // of regions, row by row, left to right
  std::span<const Region> regions;  // labels 1.. in the order of their first pixels
  std::span<const Blob> blobs;      // largest first; contours and relations not yet filled in
  int dropped_regions = 0;
  Box looked_at;  // of the frame: beyond it nothing is known
};

class Segmenter {
 public:
  void take(Arena& arena, int width_px, int height_px);

  // O(pixels of the active part).
  RegionMap run(const EnhancedFrame& frame, const VisionParameters& parameters) noexcept;

  // Memory that the next run takes back.
  std::span<std::uint8_t> idle_memory() const { return growth_.idle_memory(); }

 private:
  struct Core;
  RowLinks link_core_row(const EnhancedFrame& frame, int y, int intensity_step);
  void choose_cores(std::span<ComponentRun> runs, int area_min_px);
  void measure_cores(std::span<const ComponentRun> runs, const EnhancedFrame& frame);
  void paint_cores(std::span<const ComponentRun> runs);
  void wait_in_row(int y, const std::uint8_t* border);
  void merge_joined_cores();
  static std::array<float, 3> mean_rgb(const Core& core);
  void find_region_runs();
  void clear_labels_from(int x, int y);
  void measure_regions();
  void drop_small(const VisionParameters& parameters);
  void move_to_front(std::span<const std::uint16_t> chosen);
  std::size_t find_roots(bool one_blob);
  void find_blobs(bool one_blob);
  void measure_blobs(std::span<const ComponentRun> runs);

  Components components_;
  ShareRows shares_;
  std::span<std::uint8_t> core_;       // two rows
  std::span<std::uint8_t> left_, up_;  // a row each
  std::span<std::int32_t> roots_;
  std::span<Core> cores_;
  std::span<CoreColour> colours_;
  RegionGrowth growth_;
  std::span<Run> runs_;
  std::span<Region> regions_;  // by core, then those kept in their order
  std::span<Blob> blobs_;
  std::span<std::uint16_t> labels_;
  int stride_px_ = 0;
  Box active_;
  std::size_t core_count_ = 0, run_count_ = 0, region_count_ = 0, blob_count_ = 0;
  int dropped_ = 0;
};

}  // namespace aspect
