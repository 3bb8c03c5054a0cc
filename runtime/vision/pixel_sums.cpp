#include "runtime/vision/pixel_sums.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

// Sums of u, u^2, u^3 over u in [0, n).
struct PowerSums {
  double first, second, third;
};
PowerSums powers_below(double n) {
  const double first = n * (n - 1) / 2;
  return {first, n * (n - 1) * (2 * n - 1) / 6, first * first};
}

}  // namespace

void add_run(PixelSums& sums, const Run& run, const Box& box) {
  const PowerSums high = powers_below(run.end - box.x), low = powers_below(run.begin - box.x);
  const double n = run.end - run.begin, y = run.row - box.y;
  const double x = high.first - low.first, xx = high.second - low.second;
  sums.area += n;
  sums.x += x;
  sums.y += n * y;
  sums.xx += xx;
  sums.xy += x * y;
  sums.yy += n * y * y;
  sums.xxx += high.third - low.third;
  sums.xxy += xx * y;
  sums.xyy += x * y * y;
  sums.yyy += n * y * y * y;
}

Moments moments_of(const PixelSums& s) {
  const double n = s.area, x = s.x / n, y = s.y / n;
  const double xx = s.xx - x * s.x, xy = s.xy - x * s.y, yy = s.yy - y * s.y;
  const double xxx = s.xxx - 3 * x * s.xx + 2 * x * x * s.x;
  const double xxy = s.xxy - 2 * x * s.xy - y * s.xx + 2 * x * x * s.y;
  const double xyy = s.xyy - 2 * y * s.xy - x * s.yy + 2 * y * y * s.x;
  const double yyy = s.yyy - 3 * y * s.yy + 2 * y * y * s.y;
  const double second = 1 / (n * n), third = second / std::sqrt(n);
  const auto scaled = [](double a, double b) { return static_cast<float>(a * b); };
  return {scaled(xx, second), scaled(xy, second), scaled(yy, second), scaled(xxx, third),
          scaled(xxy, third), scaled(xyy, third), scaled(yyy, third)};
}

float thickness_px_of(const PixelSums& s) {
  const double n = s.area, x = s.x / n, y = s.y / n;
  // A pixel is a square, not a point: 1/12 along either axis.
  const double xx = s.xx / n - x * x + 1.0 / 12, yy = s.yy / n - y * y + 1.0 / 12;
  const double xy = s.xy / n - x * y;
  const double smaller = (xx + yy) / 2 - std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
  return static_cast<float>(std::sqrt(12 * std::max(smaller, 0.0)));
}

}  // namespace aspect
