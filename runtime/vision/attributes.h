// Attributes of contours (thesis 3.2.2): the nodes of the graph from regions and their borders.
#pragma once

#include "runtime/vision/contour_trace.h"
#include "runtime/vision/segment.h"
#include "runtime/vision/view_graph.h"

namespace aspect {

ShapeClass shape_class(const Moments& moments);

// External contours carry their region's attributes, internal ones those of the polygon that they
// enclose and their region's colour.
Contour describe(const RegionMap& map, const TracedContour& traced);

}  // namespace aspect
