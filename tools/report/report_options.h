// The command line of aspect-report.
#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "tools/report/report_contents.h"

namespace aspect {

// Of an input of lines.
struct LineSettings {
  std::vector<std::filesystem::path> indexes;
  std::filesystem::path configuration, truth, symmetries;  // empty: none
};

struct ReportOptions {
  std::filesystem::path input;
  std::filesystem::path output;   // of the page
  std::filesystem::path figures;  // folder; empty: none are written
  ReportSettings settings;
  LineSettings lines;
};

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<ReportOptions, int> parse_report_options(int argc, const char* const* argv);

}  // namespace aspect
