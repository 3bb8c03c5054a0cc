// The report as one HTML file, and its figures as files of their own.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/report/report_contents.h"

namespace aspect {

// Style, script, pictures and numbers all in it; it asks the network for nothing.
std::string report_page(const ReportContents& contents);

// File names and SVG texts: sphere.svg, coverage.svg, aspect_000.svg and so on.
std::vector<std::pair<std::string, std::string>> report_figures(const ReportContents& contents);

}  // namespace aspect
