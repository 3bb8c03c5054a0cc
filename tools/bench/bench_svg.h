// Plots of what the stages cost.
#pragma once

#include <span>
#include <string>

#include "tools/bench/bench_results.h"

namespace aspect {

// An SVG document, in so far as it was measured: where the time of a view goes, stage by stage, a
// bar an object (observe, match and store); what compiling costs by level, a line an object
// (compile_to_level); and all else as it is. Fails where nothing was measured.
Result<std::string> bench_svg(std::span<const BenchResult> results);

}  // namespace aspect
