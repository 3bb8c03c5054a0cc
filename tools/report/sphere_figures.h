// The viewing sphere in drawings, as the thesis has it: Figures 4.8 to 4.21.
#pragma once

#include "tools/report/report_contents.h"
#include "tools/report/svg_figure.h"

namespace aspect {

struct SphereMarks {
  bool patches = false;      // the sides of all patches
  bool tried_views = false;  // where views were right, near and wrong
  bool blind_spots = false;
};

// One half with its name and the object as it is seen from its middle. Aspects are paths with
// data-aspect, their number.
SvgFigure half_figure(const ReportContents& contents, const HalfSphereView& half,
                      const SphereMarks& marks);

// The six of them, in the thesis's order.
SvgFigure sphere_figure(const ReportContents& contents, const SphereMarks& marks);

// The object with its axes, and the sphere from the same direction.
SvgFigure overview_figure(const ReportContents& contents);

}  // namespace aspect
