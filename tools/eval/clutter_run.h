// The way of aspect-eval --clutter, from objects that are loaded to the printed result.
#pragma once

#include <span>

#include "tools/eval/eval_options.h"
#include "tools/eval/evaluation.h"
#include "tools/replay/console.h"

namespace aspect {

// Tells the console what was no good.
void run_clutter(std::span<const EvaluatedObject> objects, const EvalOptions& options,
                 Console& console);

}  // namespace aspect
