// Sums over pixels, run by run, and the moments that follow from them.
#pragma once

#include "runtime/vision/components.h"
#include "runtime/vision/view_graph.h"

namespace aspect {

// Sums over the pixels of a region, about the upper left corner of its box. Doubles hold them
// exactly up to 2^53; beyond, the order of summation is fixed.
struct PixelSums {
  double area = 0;
  double x = 0, y = 0;
  double xx = 0, xy = 0, yy = 0;
  double xxx = 0, xxy = 0, xyy = 0, yyy = 0;
};

// Adds the pixels of a run in constant time; the sums are about the corner of `box`.
void add_run(PixelSums& sums, const Run& run, const Box& box);

// Central moments from sums.
Moments moments_of(const PixelSums& sums);

// Of a bar with the same smaller second moment: sqrt(12 * smaller eigenvalue of the covariance).
float thickness_px_of(const PixelSums& sums);

}  // namespace aspect
