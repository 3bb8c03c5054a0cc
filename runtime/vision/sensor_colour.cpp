#include "runtime/vision/sensor_colour.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "runtime/vision/surface_codes.h"

namespace aspect {
namespace {

constexpr float kAll = 255;

std::array<float, 3> balance(float first_share) {
  return {kAll * first_share, kAll * (1 - first_share), 0};
}

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
    contour.mean_rgb = balance(grey / std::max(grey + mean, 1.0F));
  }
}

void colour_by_slant(const RangeCamera& camera, std::span<Contour> contours) {
  static const float kSlantShare =
      std::getenv("SLANT") ? std::strtof(std::getenv("SLANT"), nullptr) : 0.25F;
  for (Contour& contour : contours) {
    const Normal normal = normal_of_code(contour.mean_rgb);
    const float x = (contour.centre_px.x - camera.centre_x_px) / camera.focal_px;
    const float y = (contour.centre_px.y - camera.centre_y_px) / camera.focal_px;
    const float along = (normal[0] * x + normal[1] * y + normal[2]) / std::sqrt(x * x + y * y + 1);
    contour.mean_rgb = balance(kSlantShare * std::clamp(along, 0.0F, 1.0F));
  }
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
