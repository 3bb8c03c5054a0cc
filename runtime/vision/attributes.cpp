#include "runtime/vision/attributes.h"

#include <algorithm>

namespace aspect {
namespace {

// Sums over the pixels strictly inside a hole's border are not at hand; the polygon through the
// border's pixel centres is, by Green's theorem.
PixelSums polygon_sums(std::span<const std::uint8_t> chain) {
  PixelSums s;
  double x = 0, y = 0;
  for (const std::uint8_t code : chain) {
    const double u = x + kStepX[code], v = y + kStepY[code];
    const double cross = x * v - u * y;
    s.area += cross / 2;
    s.x += (x + u) * cross / 6;
    s.y += (y + v) * cross / 6;
    s.xx += (x * x + x * u + u * u) * cross / 12;
    s.xy += (2 * x * y + x * v + u * y + 2 * u * v) * cross / 24;
    s.yy += (y * y + y * v + v * v) * cross / 12;
    s.xxx += (x + u) * (x * x + u * u) * cross / 20;
    s.xxy += (x * x * (3 * y + v) + 2 * x * u * (y + v) + u * u * (y + 3 * v)) * cross / 60;
    s.xyy += (y * y * (3 * x + u) + 2 * y * v * (x + u) + v * v * (x + 3 * u)) * cross / 60;
    s.yyy += (y + v) * (y * y + v * v) * cross / 20;
    x = u;
    y = v;
  }
  if (s.area < 0)
    for (double* sum : {&s.area, &s.x, &s.y, &s.xx, &s.xy, &s.yy, &s.xxx, &s.xxy, &s.xyy, &s.yyy})
      *sum = -*sum;
  return s;
}

Box chain_box(const TracedContour& traced) {
  int x = traced.start_x, y = traced.start_y;
  int left = x, right = x, top = y, bottom = y;
  for (const std::uint8_t code : traced.chain) {
    x += kStepX[code];
    y += kStepY[code];
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  return {left, top, right - left + 1, bottom - top + 1};
}

}  // namespace

std::array<float, 4> hu_invariants(const Moments& m) {
  const float sum = m.xx + m.yy, difference = m.xx - m.yy;
  const float a = m.xxx - 3 * m.xyy, b = 3 * m.xxy - m.yyy;
  const float c = m.xxx + m.xyy, d = m.xxy + m.yyy;
  return {sum, difference * difference + 4 * m.xy * m.xy, a * a + b * b, c * c + d * d};
}

ShapeClass shape_class(const Moments& m) {
  // Halfway between the invariants of ellipse, parallelogram and triangle; above the last, as far
  // again as the parallelogram is below it.
  constexpr float kEllipse = 0.0063326F, kParallelogram = 1 / 144.0F, kTriangle = 1 / 108.0F;
  const float invariant = m.xx * m.yy - m.xy * m.xy;
  if (invariant < (kEllipse + kParallelogram) / 2) return ShapeClass::circle;
  if (invariant < (kParallelogram + kTriangle) / 2) return ShapeClass::square;
  if (invariant < kTriangle + (kTriangle - kParallelogram) / 2) return ShapeClass::triangle;
  return ShapeClass::other;
}

Contour describe(const RegionMap& map, const TracedContour& traced) {
  const Region& region = map.regions[traced.label - 1U];
  Contour contour;
  contour.region = traced.label;
  contour.blob = static_cast<std::uint16_t>(region.blob);
  contour.inside = traced.external ? traced.inside : traced.label;
  contour.external = traced.external;
  contour.box = traced.external ? region.box : chain_box(traced);
  contour.start_x = traced.start_x;
  contour.start_y = traced.start_y;
  contour.chain = traced.chain;
  contour.mean_rgb = region.mean_rgb;
  const PixelSums sums = traced.external ? region.sums : polygon_sums(traced.chain);
  const double origin_x = traced.external ? region.box.x : traced.start_x;
  const double origin_y = traced.external ? region.box.y : traced.start_y;
  contour.area_px = static_cast<float>(sums.area);
  contour.centre_px = {static_cast<float>(origin_x + sums.x / sums.area),
                       static_cast<float>(origin_y + sums.y / sums.area)};
  contour.moments = moments_of(sums);
  contour.thickness_px = thickness_px_of(sums);
  contour.shape = shape_class(contour.moments);
  return contour;
}

}  // namespace aspect
