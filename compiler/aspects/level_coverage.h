// What a model would have been at each of its lower levels: the rows of the thesis's Tables 4.2 to
// 4.12.
#pragma once

#include <vector>

#include "compiler/aspects/clusters.h"

namespace aspect {

struct LevelCoverage {
  int level = 0;
  std::size_t patches = 0, views = 0;
  std::size_t match_calls = 0;  // pairs of equal node counts, as often as they were asked for
  std::size_t clusters = 0;
  double area_fraction = 0;  // of the sphere, in patches of one aspect
};

// From level 2 on, as the thesis, or from the subdivision's own where that is less, to the highest.
// Nothing is rendered: a model of a lower level has the first views and matches of a higher one.
// Matches below options.min_level, where patches are split without question, are missing and are
// added. O(levels * patches).
std::vector<LevelCoverage> coverage_by_level(Subdivision& subdivision,
                                             const CompileOptions& options);

}  // namespace aspect
