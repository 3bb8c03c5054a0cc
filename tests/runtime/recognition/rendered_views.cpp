#include "tests/runtime/recognition/rendered_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace aspect {

ClassIndex model_index(const std::string& name, int level) {
  const std::vector<std::uint8_t> bytes = model_index_bytes(name, level);
  return parse_index(std::as_bytes(std::span(bytes)), name).value();
}

OwnedFrame beside(const OwnedFrame& left, const OwnedFrame& right) {
  OwnedFrame both{left.width_px + right.width_px, std::max(left.height_px, right.height_px), {}};
  both.rgb.resize(static_cast<std::size_t>(3 * both.width_px * both.height_px));
  int x = 0;
  for (const OwnedFrame* part : {&left, &right}) {
    for (int y = 0; y < part->height_px; ++y)
      std::copy_n(part->rgb.begin() + std::ptrdiff_t{3} * y * part->width_px, 3 * part->width_px,
                  both.rgb.begin() + std::ptrdiff_t{3} * (y * both.width_px + x));
    x += part->width_px;
  }
  return both;
}

// Uniform on the sphere (Marsaglia 1972).
Eigen::Vector3d random_direction(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (;;) {
    const double u = coordinate(random), v = coordinate(random), w = u * u + v * v;
    if (w >= 1) continue;
    const double ring = 2 * std::sqrt(1 - w);
    return {u * ring, v * ring, 1 - 2 * w};
  }
}

double angle_deg(const Vector3& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d d(static_cast<double>(a[0]), static_cast<double>(a[1]),
                          static_cast<double>(a[2]));
  return std::acos(std::clamp(d.dot(b) / d.norm(), -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace aspect
