// From the command line to the verdict.
#pragma once

#include "tools/score/score_options.h"

namespace aspect {

// The program's exit code: 0, or 1 where a demand is missed, a frame is missing or a file was no
// good.
int run_score(const ScoreOptions& options);

}  // namespace aspect
