// What is drawn over a frame, as paths of SVG in the frame's pixels.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "runtime/recognition/model_lines.h"
#include "runtime/vision/segment.h"
#include "runtime/vision/view_graph.h"

namespace aspect {

// To a tenth of a pixel; what is straight within half of one is a line.
std::string path_of(std::span<const PictureLine> lines);

// The regions as segmented: {"shown": [{"n": place of the contour in the graph, "colour":
// "#rrggbb", the region's mean, "at": [x, y] where a label fits, "path": its border and those of
// its holes, for the even-odd rule}], the largest first, "left_out": how many there was no room
// for}. Takes at most kMostContourBytes: of a frame full of things the outlines are simpler, and
// specks are left out.
nlohmann::json contours_json(const ViewGraph& graph, const RegionMap& regions);

inline constexpr std::size_t kMostContourBytes = 12U << 10U;

}  // namespace aspect
