// What frames cost.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

// The median frame's time in the recogniser, to that of reading every byte of a frame, which no
// program that looks at a frame can do without. Times are the processor's for this thread: other
// programs run beside. No configuration: what the indexes say.
Result<double> time_ratio(const std::filesystem::path& frames,
                          const std::optional<std::filesystem::path>& configuration,
                          const std::vector<std::filesystem::path>& indexes);

}  // namespace aspect
