#include "tests/runtime/recognition/rendered_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace aspect {

ClassIndex model_index(const std::string& name, int level) {
  const std::vector<std::uint8_t> bytes = model_index_bytes(name, level);
  return parse_index(std::as_bytes(std::span(bytes)), name).value();
}

const std::vector<ClassIndex>& cube_and_l_shape() {
  static const std::vector<ClassIndex> both = {model_index("cube", 3), model_index("l_shape", 3)};
  return both;
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

OwnedFrame striped(int width_px, int height_px) {
  constexpr std::array<std::array<int, 3>, 3> kColours{
      {{115, 38, 204}, {140, 217, 26}, {217, 26, 102}}};
  constexpr int kWidth_px = 23;
  OwnedFrame frame{width_px, height_px, {}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      for (const int channel : kColours[static_cast<std::size_t>((2 * x + y) / kWidth_px % 3)])
        frame.rgb.push_back(
            static_cast<std::uint8_t>(channel * (80 + (x / 16 + y / 16) % 4 * 10) / 110));
  return frame;
}

void paste(const OwnedFrame& object, int right_px, int down_px, OwnedFrame& onto) {
  constexpr int kBlack = 48;
  for (int y = std::max(0, down_px); y < std::min(onto.height_px, object.height_px + down_px); ++y)
    for (int x = std::max(0, right_px); x < std::min(onto.width_px, object.width_px + right_px);
         ++x) {
      const auto from =
          object.rgb.begin() + std::ptrdiff_t{3} * ((y - down_px) * object.width_px + x - right_px);
      if (from[0] + from[1] + from[2] >= kBlack)
        std::copy_n(from, 3, onto.rgb.begin() + std::ptrdiff_t{3} * (y * onto.width_px + x));
    }
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
