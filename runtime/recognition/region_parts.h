// What a frame shows that may be one surface of an object: its regions as they are; the two sides
// of a cut through the neck between two concave corners, since surfaces of one colour that touch
// are one region; and pairs of neighbours that only light parts.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/vision/planes.h"
#include "runtime/vision/segment.h"
#include "runtime/vision/view_graph.h"

namespace aspect {

struct RegionPart {
  Point2 centre_px;
  float area_px = 0;
  Moments moments;
  std::array<float, 3> mean_rgb{};
  std::uint16_t label = 0;  // of a region that it is of, from 1
  bool is_region = false;   // as it is
};

class RegionParts {
 public:
  static constexpr std::size_t kMost = 448, kMostRegions = 320;

  // Parts smaller than a few pixels are left out, and the smallest of more regions than
  // kMostRegions, which come first.
  // O(runs + lengths of the contours).
  void find(const RegionMap& regions, const Planes& colours, std::span<const Contour> contours);

  std::span<const RegionPart> all() const { return std::span(parts_).first(count_); }

 private:
  struct Touch;

  void add(const RegionPart& part);
  void add_region(const RegionPart& part);
  void add_whole(const RegionMap& regions);
  void add_cut(const RegionMap& regions, const Planes& colours, const Contour& contour);
  void add_joined(const RegionMap& regions);

  std::array<RegionPart, kMost> parts_{};
  std::size_t count_ = 0;
};

}  // namespace aspect
