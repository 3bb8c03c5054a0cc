// Arcs of the attributed relational graph (thesis 3.2.2, "Relations between contours").
#pragma once

#include <span>

#include "runtime/vision/view_graph.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// 16-way direction of a vector, 0 = +x, then every 22.5 degrees towards +y (figure 3.3).
std::uint8_t direction_code(Point2 vector);

// Number of steps between two direction codes, 0..8.
int direction_distance(std::uint8_t a, std::uint8_t b);

// The relation of every ordered pair of contours, by `from`, then `to`, or with a choice of them
// (see VisionParameters) only the chosen. Writes at most out.size() of them, returns their number.
// O(n^2 log n).
int relate(std::span<const Contour> contours, RelationChoice choice, int relations_max,
           std::span<Relation> out);

}  // namespace aspect
