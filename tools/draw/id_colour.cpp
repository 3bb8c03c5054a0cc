#include "tools/draw/id_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace aspect {

cv::Scalar id_colour(int id) {
  // Steps of the golden ratio round the colour circle never come near an earlier hue soon; three
  // saturations tell apart those that do in the end.
  constexpr double kGoldenRatio = 0.618033988749895;
  constexpr std::array<double, 3> kSaturations = {0.85, 0.55, 0.7};
  const double hue = 6 * std::fmod(0.07 + kGoldenRatio * id, 1.0);
  const double saturation = kSaturations[static_cast<std::size_t>(std::abs(id)) % 3];
  const auto channel = [&](double shift) {
    const double distance = std::abs(std::fmod(hue + shift, 6.0) - 3.0);
    return 255 * (1 - saturation * (1 - std::clamp(distance - 1, 0.0, 1.0)));
  };
  return {channel(2), channel(4), channel(0)};
}

}  // namespace aspect
