// The command line of aspect-report.
#pragma once

#include <filesystem>
#include <variant>

#include "tools/report/report_contents.h"

namespace aspect {

struct ReportOptions {
  std::filesystem::path input;
  std::filesystem::path output;   // of the page
  std::filesystem::path figures;  // folder; empty: none are written
  ReportSettings settings;
};

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<ReportOptions, int> parse_report_options(int argc, const char* const* argv);

}  // namespace aspect
