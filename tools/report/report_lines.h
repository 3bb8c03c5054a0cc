// What aspect-report makes of the lines that aspect-replay wrote: a page of the frames.
#pragma once

#include "compiler/store/done.h"
#include "runtime/base/result.h"
#include "tools/report/report_options.h"

namespace aspect {

// By its name: .ndjson or .jsonl.
bool holds_lines(const std::filesystem::path& input);

// Tells on standard error how far it is, and of how many frames the picture is gone.
Result<Done> report_lines(const ReportOptions& options);

}  // namespace aspect
