#include "runtime/vision/feature.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/portable_math.h"

namespace aspect {

ContourFeature feature_of(const Contour& contour, const Blob& blob) {
  ContourFeature feature;
  const float sum = std::max(contour.mean_rgb[0] + contour.mean_rgb[1] + contour.mean_rgb[2], 1.0F);
  for (std::size_t channel = 0; channel < 3; ++channel)
    feature.share[channel] = contour.mean_rgb[channel] / sum;
  const float size_px = std::sqrt(blob.area_px);
  feature.position = {(contour.centre_px.x - blob.centre_px.x) / size_px,
                      (contour.centre_px.y - blob.centre_px.y) / size_px};
  feature.area = contour.area_px / blob.area_px;
  feature.moments = contour.moments;
  return feature;
}

Moments turned(const Moments& m, float c, float s) {
  Moments out;
  out.xx = c * c * m.xx - 2 * c * s * m.xy + s * s * m.yy;
  out.xy = c * s * (m.xx - m.yy) + (c * c - s * s) * m.xy;
  out.yy = s * s * m.xx + 2 * c * s * m.xy + c * c * m.yy;
  out.xxx = c * c * c * m.xxx - 3 * c * c * s * m.xxy + 3 * c * s * s * m.xyy - s * s * s * m.yyy;
  out.xxy = c * c * s * m.xxx + (c * c * c - 2 * c * s * s) * m.xxy +
            (s * s * s - 2 * c * c * s) * m.xyy + c * s * s * m.yyy;
  out.xyy = c * s * s * m.xxx + (2 * c * c * s - s * s * s) * m.xxy +
            (c * c * c - 2 * c * s * s) * m.xyy - c * c * s * m.yyy;
  out.yyy = s * s * s * m.xxx + 3 * c * s * s * m.xxy + 3 * c * c * s * m.xyy + c * c * c * m.yyy;
  return out;
}

ContourFeature turned(const ContourFeature& feature, float c, float s) {
  ContourFeature out = feature;
  out.position = {c * feature.position.x - s * feature.position.y,
                  s * feature.position.x + c * feature.position.y};
  out.moments = turned(feature.moments, c, s);
  return out;
}

TypeAttributes type_attributes(const ContourFeature& feature) {
  constexpr float kShare = 0.05F, kArea = 0.15F, kDistance = 0.2F, kSpread = 0.4F,
                  kAsymmetry = 0.05F;
  const std::array<float, 4> hu = hu_invariants(feature.moments);
  // 1/6 is the spread of a square; slivers reach tens of it.
  const float spread =
      static_cast<float>(portable_log(static_cast<double>(std::max(6 * hu[0], 0.5F))));
  const float asymmetry = std::min(std::sqrt(hu[2]), 0.3F);
  return {feature.share[0] / kShare,
          feature.share[1] / kShare,
          feature.share[2] / kShare,
          feature.area / kArea,
          portable_hypot(feature.position.x, feature.position.y) / kDistance,
          spread / kSpread,
          asymmetry / kAsymmetry};
}

float squared_type_distance(const TypeAttributes& a, const TypeAttributes& b) {
  float sum = 0;
  for (std::size_t d = 0; d < kTypeDimensions; ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}

std::uint16_t nearest_type(std::span<const TypeAttributes> types, const TypeAttributes& sample) {
  std::uint16_t best = 0;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < types.size(); ++k) {
    const float distance = squared_type_distance(types[k], sample);
    if (distance >= least) continue;
    least = distance;
    best = static_cast<std::uint16_t>(k);
  }
  return best;
}

}  // namespace aspect
