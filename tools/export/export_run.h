// From a store to a folder of the thesis's files.
#pragma once

#include <atomic>

#include "tools/export/export_options.h"

namespace aspect {

// The program's exit code: 0, or 1 after one line on standard error.
int run_export(const ExportOptions& options, const std::atomic<bool>* stop);

}  // namespace aspect
