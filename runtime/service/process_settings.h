// How the process of aspectd runs.
#pragma once

#include <optional>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

struct ProcessSettings {
  bool lock_memory = false;   // never swapped out
  int realtime_priority = 0;  // 1 to 99: before all ordinary processes; 0: as one of them
  std::vector<int> cpus;      // that the frame loop may run on; none: all
  friend bool operator==(const ProcessSettings&, const ProcessSettings&) = default;
};

// For the calling thread, memory for the whole process: what is taken later is locked, too. One
// line where the system does not permit it.
[[nodiscard]] std::optional<Error> apply(const ProcessSettings& settings);

}  // namespace aspect
