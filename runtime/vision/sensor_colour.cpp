#include "runtime/vision/sensor_colour.h"

#include <algorithm>

#include "runtime/vision/surface_codes.h"

namespace aspect {
namespace {

constexpr float kAll = 255;

}  // namespace

void colour_by_grey(std::span<Contour> contours) {
  double sum = 0, area = 0;
  for (const Contour& contour : contours) {
    if (!contour.external) continue;
    sum += static_cast<double>(contour.mean_rgb[0]) * static_cast<double>(contour.area_px);
    area += static_cast<double>(contour.area_px);
  }
  const auto mean = static_cast<float>(sum / std::max(area, 1.0));
  for (Contour& contour : contours) {
    const float grey = contour.mean_rgb[0];
    contour.mean_rgb = {kAll * grey / std::max(grey + mean, 1.0F),
                        kAll * mean / std::max(grey + mean, 1.0F), 0};
  }
}

void colour_alike(std::span<Contour> contours) {
  for (Contour& contour : contours) contour.mean_rgb = {kAll / 3, kAll / 3, kAll / 3};
}

void colour_by_surface(std::span<Contour> contours) {
  // Roberts's quasirandom sequence, 2^32 / g and 2^32 / g^2 with g^3 = g + 1, folded into the
  // triangle of shares.
  constexpr std::uint32_t kFirst = 3242174889U, kSecond = 2447445414U;
  for (Contour& contour : contours) {
    const auto id = static_cast<std::uint32_t>(surface_id_of(contour.mean_rgb));
    std::uint32_t a = (id * kFirst) >> 24U, b = (id * kSecond) >> 24U;
    if (a + b > 255) {
      a = 255 - a;
      b = 255 - b;
    }
    contour.mean_rgb = {static_cast<float>(a), static_cast<float>(b),
                        static_cast<float>(255 - a - b)};
  }
}

}  // namespace aspect
