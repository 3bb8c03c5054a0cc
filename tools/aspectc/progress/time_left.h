// How long a compilation still takes.
//
// A view costs what the views of this run have cost on the average, with the matches made so far.
// To come are the views of this level that are not rendered yet, and for every further level twice
// as many as for the level before: patches are split along the borders between aspects, and a line
// meets twice as many patches of half the size. Matches of this level are extrapolated from those
// made since they began. A round of bisection takes about as many views as the last level.
//
// Weak side: before the first level is matched nobody knows how long its borders are; up to the
// smallest level every patch is split, and twice that may be far too much for a plain object.
#pragma once

#include <optional>

#include "compiler/aspects/subdivision.h"

namespace aspect {

struct TimeSpent {
  double run_s = 0;      // since the first view was begun
  double matches_s = 0;  // since the first match of this level was begun
};

// Nothing where there is nothing to tell it from yet.
std::optional<double> seconds_left(const Progress& progress, int last_level,
                                   const TimeSpent& spent);

}  // namespace aspect
