// What aspect-report does, by the kind of its input.
#pragma once

#include "tools/report/report_options.h"

namespace aspect {

// Writes the page, and the figures where they are asked for. Exit code.
int run_report(const ReportOptions& options);

}  // namespace aspect
