#include "runtime/recognition/light_estimate.h"

#include <algorithm>

namespace aspect {

LightGain estimate_light(std::span<const ContourFeature> seen, std::span<const KeyContour> key,
                         const Assignment& assignment) {
  LightGain light;
  constexpr int kRounds = 4;
  constexpr float kLeast = 0.5F, kMost = 2;
  for (int round = 0; round < kRounds; ++round) {
    std::array<float, 3> observed{}, expected{};
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (assignment.column_of[i] < 0) continue;
      const std::array<float, 3> share =
          lit(key[static_cast<std::size_t>(assignment.column_of[i])].feature.share, light);
      for (std::size_t c = 0; c < 3; ++c) {
        observed[c] += seen[i].area * seen[i].share[c];
        expected[c] += seen[i].area * share[c];
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      constexpr float kLeastShare = 1e-3F;
      if (expected[c] < kLeastShare || observed[c] < kLeastShare) continue;
      light.rgb[c] = std::clamp(light.rgb[c] * observed[c] / expected[c], kLeast, kMost);
    }
  }
  return light;
}

}  // namespace aspect
