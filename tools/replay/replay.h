// Recorded frames through the runtime, one line of JSON each.
#pragma once

#include "tools/replay/replay_options.h"

namespace aspect {

// The program's exit code: 0, or 1 where a file, a frame or an index was no good.
int replay(const ReplayOptions& options);

}  // namespace aspect
