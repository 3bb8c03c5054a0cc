// Step 5 of the thesis's segmentation (3.2.2): the borders of regions as 8-direction chain codes.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/segment.h"

namespace aspect {

struct TracedContour {
  std::uint16_t label = 0;   // of the region
  std::uint16_t inside = 0;  // the region that surrounds it, 0: none
  bool external = true;
  int start_x = 0, start_y = 0;
  std::span<const std::uint8_t> chain;
};

// Steps of the eight chain codes: 0 = +x, then clockwise on the screen.
inline constexpr int kStepX[8] = {1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr int kStepY[8] = {0, 1, 1, 1, 0, -1, -1, -1};

// Area of the polygon through the chain's pixel centres.
double enclosed_area_px(std::span<const std::uint8_t> chain);

class ContourTracer {
 public:
  void take(Arena& arena, int width_px, int height_px);

  // Memory for the chains of the next run, which lie in it from then on.
  void lend(std::span<std::uint8_t> chains) { chains_ = chains; }

  // Borders of all regions in the order of their first pixels, external and internal ones (holes
  // of at least hole_area_min_px). `dropped` counts contours lost
  // to a capacity. O(pixels of the active part + border pixels).
  std::span<const TracedContour> run(const RegionMap& map, int hole_area_min_px,
                                     int& dropped) noexcept;

 private:
  struct Surrounding;
  struct Walk;
  int next_direction(const RegionMap& map, const Walk& walk, Surrounding& surrounding);
  bool trace(const RegionMap& map, int x, int y, bool external);
  void forget_seen(const RegionMap& map);
  void see_east(std::size_t pixel) { east_seen_[pixel / 64] |= std::uint64_t{1} << (pixel % 64); }
  bool east_seen(std::size_t pixel) const {
    return (east_seen_[pixel / 64] >> (pixel % 64) & 1U) != 0;
  }
  std::uint16_t label_at(const RegionMap& map, int x, int y) const;

  std::span<std::uint64_t> east_seen_;  // a bit a pixel: its east side was traced
  std::span<std::uint8_t> chains_;
  std::span<TracedContour> contours_;
  std::size_t chain_bytes_ = 0;
  std::size_t contour_count_ = 0;
};

}  // namespace aspect
