// What a picture turns into: an attributed relational graph (thesis 3.2.2) of its coloured
// regions. Nodes are contours with their attributes, arcs the relations between them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/vision/frame.h"

namespace aspect {

// By the affine moment invariant (mu20 mu02 - mu11^2) / area^4, which is 1/(16 pi^2) for every
// ellipse, 1/144 for every parallelogram and 1/108 for every triangle, whatever the direction
// they are seen from (as long as perspective is weak).
enum class ShapeClass : std::uint8_t { circle, square, triangle, other };

struct Point2 {
  float x = 0, y = 0;
};

// Central moments of a region, divided by the power of its area that makes them free of scale.
struct Moments {
  float xx = 0, xy = 0, yy = 0;              // second order / area^2
  float xxx = 0, xxy = 0, xyy = 0, yyy = 0;  // third order / area^2.5
};

// The first four of Hu's invariants, free of scale, place and roll: the thesis's mm().
std::array<float, 4> hu_invariants(const Moments& moments);

struct Contour {
  std::uint16_t region = 0;  // its label in the RegionMap, from 1
  std::uint16_t blob = 0;    // index into ViewGraph::blobs
  std::uint16_t inside = 0;  // the region that surrounds it, 0: none
  bool external = true;      // false: the border of a hole in the region
  ShapeClass shape = ShapeClass::other;
  std::array<float, 3> mean_rgb{};  // 0..255; of other sensors see sensor_colour.h
  Point2 centre_px;
  float area_px = 0;
  float thickness_px = 0;  // of a bar with the same smaller second moment
  Moments moments;
  Box box;
  // Freeman chain: border pixels from start_x, start_y, one step a code, 0 = +x, then every
  // 45 degrees towards +y (on the screen: clockwise).
  int start_x = 0, start_y = 0;
  std::span<const std::uint8_t> chain;
};

// Where `to` lies as seen from `from`.
struct Relation {
  enum class Kind : std::uint8_t { apart, superimposed, inside, outside };
  std::uint16_t from = 0, to = 0;  // contours, counted from the first one of the blob
  std::uint8_t direction = 0;      // 16 ways, 0 = +x, then every 22.5 degrees towards +y
  Kind kind = Kind::apart;         // inside: `to` surrounds `from`; outside: the reverse
};

// One connected foreground piece of a frame. Contours [first_contour, first_contour + count).
struct Blob {
  int first_contour = 0;
  int contour_count = 0;
  int first_relation = 0;
  int relation_count = 0;
  Box box;
  Point2 centre_px;   // of its foreground pixels
  float area_px = 0;  // number of its foreground pixels
};

struct ViewGraph {
  std::span<const Contour> contours;    // by blob, within it in the order found
  std::span<const Relation> relations;  // by blob
  std::span<const Blob> blobs;          // largest first
  int dropped_regions = 0;              // lost to a capacity: the smallest ones, or the lowest rows
};

}  // namespace aspect
