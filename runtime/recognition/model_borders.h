// Where a drawn model shows borders between colours: silhouettes and inner ones.
#pragma once

#include <cstddef>
#include <span>

#include "runtime/recognition/model_drawing.h"

namespace aspect {

struct BorderPoint {
  Vector3d point_object{};
  float x_px = 0, y_px = 0;          // in the straight picture
  float normal_x = 0, normal_y = 0;  // unit length, from `inside` to `outside`
  ColourClass inside = kBackgroundClass, outside = kBackgroundClass;
};

inline constexpr std::size_t kMaxBorderPoints = 128;

// Points spread evenly over the borders that the drawing shows; returns how many. A point lies on
// an edge of the model, is hidden by nothing, and has the edge's own colour on one side and another
// one on the other. Deterministic. O(edges + points).
std::size_t find_border_points(const ObjectModel& model, const ModelDrawing& drawing,
                               std::span<BorderPoint> points);

}  // namespace aspect
