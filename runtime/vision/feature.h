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
