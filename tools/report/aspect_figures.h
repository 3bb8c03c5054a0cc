// One aspect in drawings: its views with their named contours, and its graph.
#pragma once

#include "tools/report/report_contents.h"
#include "tools/report/svg_figure.h"

namespace aspect {

// The picture, its contours' outlines and names. Outlines are paths with data-contour, their name.
SvgFigure view_figure(const SeenView& view);

// The attributed relational graph of the aspect's typical view (thesis 3.2.2): contours at their
// places, sizes and colours, and the relations between them.
SvgFigure graph_figure(const ReportContents& contents, std::size_t aspect);
SvgFigure graph_key_figure();

// All of the above on a sheet.
SvgFigure aspect_figure(const ReportContents& contents, std::size_t aspect);

// "#rrggbb" of colour shares, as light as it can be.
std::string colour_of_shares(const std::array<float, 3>& share);

}  // namespace aspect
