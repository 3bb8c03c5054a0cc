// Files of this folder that are built in.
#pragma once

#include <string_view>

namespace aspect {

extern const std::string_view kReportPage;        // report_page.html
extern const std::string_view kReportStyle;       // report_style.css
extern const std::string_view kReportScript;      // report_script.js
extern const std::string_view kTurntableScript;   // turntable.js
extern const std::string_view kThesisStatistics;  // thesis_statistics.csv

}  // namespace aspect
