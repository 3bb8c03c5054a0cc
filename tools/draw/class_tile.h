// A class of an index as a small picture, from the index alone.
#pragma once

#include <opencv2/core.hpp>

#include "runtime/recognition/class_index.h"

namespace aspect {

// The key view nearest to the class's typical one, with its contours' names at their centres. Drawn
// from the index's model; where there is none, every contour is the ellipse of its area and spread,
// in its colour shares.
cv::Mat class_tile(const ClassIndex& index, const AspectClass& aspect, int side_px);

// The view that the tile shows.
Vector3d shown_view(const ClassIndex& index, const AspectClass& aspect);

}  // namespace aspect
