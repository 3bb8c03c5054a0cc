// The regions of a frame in false colours.
#pragma once

#include <opencv2/core.hpp>

#include "runtime/vision/segment.h"
#include "runtime/vision/view_graph.h"

namespace aspect {

// Every region in the colour of its label and nothing else: what is black is in none.
cv::Mat draw_regions(const RegionMap& map, int width_px, int height_px);

// The same with every contour's number in the graph, holes in brackets. `map` and `graph` are of
// the same frame of width x height. Small frames are blown up.
cv::Mat draw_numbered_regions(const RegionMap& map, const ViewGraph& graph, int width_px,
                              int height_px);

}  // namespace aspect
