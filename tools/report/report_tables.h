// The numbers of a report as HTML: static, so that they print and need no script.
#pragma once

#include <string>

#include "tools/report/report_contents.h"

namespace aspect {

// Ours by level, and the thesis's rows below where it has the object.
std::string coverage_table(const ReportContents& contents);

// What aspectc explain says: accuracy, confusions, blind spots, cures.
std::string accuracy_list(const Explanation& explanation);
std::string confusion_list(const ReportContents& contents);
std::string blind_spot_list(const Explanation& explanation);
std::string cure_list(const Explanation& explanation);

std::string symmetry_list(const ReportContents& contents);

// What an index of --max-index-kib leaves out, and what would hold all.
std::string budget_list(const ReportContents& contents);

// Of the compilation and of its store.
std::string statistics_list(const ReportContents& contents);

}  // namespace aspect
