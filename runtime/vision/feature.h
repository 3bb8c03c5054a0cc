// Attributes of a contour relative to the blob that it belongs to: free of the object's place,
// distance and brightness, but not of its roll.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/vision/view_graph.h"

namespace aspect {

struct ContourFeature {
  std::array<float, 3> share{};  // r, g, b over their sum
  Point2 position;  // of its centre from the blob's, in square roots of the blob's area
  float area = 0;   // share of the blob's area
  Moments moments;  // central, free of scale
};

ContourFeature feature_of(const Contour& contour, const Blob& blob);

// The feature as a camera sees it that is turned by -angle: positions turn by +angle (from +x
// towards +y, on the screen clockwise).
ContourFeature turned(const ContourFeature& feature, float cos_angle, float sin_angle);
Moments turned(const Moments& moments, float cos_angle, float sin_angle);

// The same turn for many: what is made of cosine and sine alone is made once.
class Turning {
 public:
  Turning(float cos_angle, float sin_angle);
  Point2 operator()(Point2 position) const {
    return {c_ * position.x - s_ * position.y, s_ * position.x + c_ * position.y};
  }
  Moments operator()(const Moments& moments) const;

 private:
  float c_, s_;
  float cc_, cs_, ss_, cs2_, cos2_;            // cs2 is 2 c s, cos2 is cc - ss
  float ccc_, ccs_, css_, sss_, ccs3_, css3_;  // ccs3 is 3 c c s
  float ccc_css2_, sss_ccs2_;                  // ccc - 2 c s s, sss - 2 c c s
};

// What a contour type is made of (thesis 3.4.3): colour shares, area, distance from the centre,
// spread and asymmetry, none of which changes with roll. Each is divided by the difference that
// counts as one, so that plain Euclidean distance weighs them: colour counts most.
inline constexpr std::size_t kTypeDimensions = 7;
using TypeAttributes = std::array<float, kTypeDimensions>;
TypeAttributes type_attributes(const ContourFeature& feature);
float squared_type_distance(const TypeAttributes& a, const TypeAttributes& b);

// The contour type nearest to a sample; ties go to the lower type. O(types).
std::uint16_t nearest_type(std::span<const TypeAttributes> types, const TypeAttributes& sample);

}  // namespace aspect
