#include "compiler/scene/aci_palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace aspect {
namespace {

using Eigen::Vector3d;

// A channel of the full hue: 1 within 60 degrees of its own, 0 from 120 on.
double channel(double hue_deg, double own_deg) {
  const double apart = std::abs(std::remainder(hue_deg - own_deg, 360.0));
  return std::clamp(2 - apart / 60, 0.0, 1.0);
}

}  // namespace

Vector3d aci_colour(int number) {
  if (number >= 1 && number <= 7) {
    constexpr std::array<unsigned, 8> kRgb = {0, 4, 6, 2, 3, 1, 5, 7};  // bits: red, green, blue
    const unsigned rgb = kRgb[static_cast<std::size_t>(number)];
    return Vector3d(rgb >> 2, rgb >> 1 & 1u, rgb & 1u);
  }
  if (number == 8) return Vector3d::Constant(0.5);
  if (number == 9) return Vector3d::Constant(0.75);
  if (number >= 250 && number <= 255) return Vector3d::Constant(0.2 + 0.16 * (number - 250));
  if (number < 10 || number > 255) return Vector3d::Zero();
  constexpr std::array<double, 5> kValues = {1, 0.65, 0.5, 0.3, 0.15};
  const double hue_deg = 15 * (number / 10 - 1);
  const double value = kValues[static_cast<std::size_t>(number % 10 / 2)];
  Vector3d colour(channel(hue_deg, 0), channel(hue_deg, 120), channel(hue_deg, 240));
  if (number % 2 == 1) colour = (colour + Vector3d::Ones()) / 2;
  return value * colour;
}

}  // namespace aspect
