// Numbers of a model as charts.
#pragma once

#include "tools/report/report_contents.h"
#include "tools/report/svg_figure.h"

namespace aspect {

// Share of the sphere in patches of one aspect and number of aspects, by level; the thesis's beside
// ours where it has the object.
SvgFigure coverage_figure(const ReportContents& contents);

// How much of the sphere the largest aspects cover together (thesis, Figure 4.19), and where the
// index stops.
SvgFigure areas_figure(const ReportContents& contents);

// Tried views by the aspect seen (row) and the one answered (column). Cells have data-aspect and
// data-taken-for.
SvgFigure confusion_figure(const ReportContents& contents);

}  // namespace aspect
