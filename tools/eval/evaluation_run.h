// From the command line to the printed result.
#pragma once

#include "tools/eval/eval_options.h"

namespace aspect {

// The program's exit code: 0, or 1 where a file was no good.
int run_evaluation(const EvalOptions& options);

}  // namespace aspect
