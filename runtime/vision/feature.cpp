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

Turning::Turning(float c, float s)
    : c_(c),
      s_(s),
      cc_(c * c),
      cs_(c * s),
      ss_(s * s),
      cs2_(2 * c * s),
      cos2_(c * c - s * s),
      ccc_(c * c * c),
      ccs_(c * c * s),
      css_(c * s * s),
      sss_(s * s * s),
      ccs3_(3 * c * c * s),
      css3_(3 * c * s * s),
      ccc_css2_(c * c * c - 2 * c * s * s),
      sss_ccs2_(s * s * s - 2 * c * c * s) {}

Moments Turning::operator()(const Moments& m) const {
  Moments out;
  out.xx = cc_ * m.xx - cs2_ * m.xy + ss_ * m.yy;
  out.xy = cs_ * (m.xx - m.yy) + cos2_ * m.xy;
  out.yy = ss_ * m.xx + cs2_ * m.xy + cc_ * m.yy;
  out.xxx = ccc_ * m.xxx - ccs3_ * m.xxy + css3_ * m.xyy - sss_ * m.yyy;
  out.xxy = ccs_ * m.xxx + ccc_css2_ * m.xxy + sss_ccs2_ * m.xyy + css_ * m.yyy;
  out.xyy = css_ * m.xxx - sss_ccs2_ * m.xxy + ccc_css2_ * m.xyy - ccs_ * m.yyy;
  out.yyy = sss_ * m.xxx + css3_ * m.xxy + ccs3_ * m.xyy + ccc_ * m.yyy;
  return out;
}

Moments turned(const Moments& moments, float c, float s) {
  return Turning(c, s)(moments);
}

ContourFeature turned(const ContourFeature& feature, float c, float s) {
  const Turning turning(c, s);
  ContourFeature out = feature;
  out.position = turning(feature.position);
  out.moments = turning(feature.moments);
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
