// Contour types: K prototypes of contours by unsupervised clustering (thesis 3.4.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/vision/feature.h"

namespace aspect {

// At most `count` centres: Lloyd's k-means from k-means++ starts (Arthur and Vassilvitskii 2007)
// greedy ones, with a fixed seed, the best of a few attempts, on at most 200,000 samples picked
// evenly, with sums in a fixed order: the same samples give the same bits for any number of
// threads. Fewer where there are fewer different samples. O(samples * count * rounds).
std::vector<TypeAttributes> find_contour_types(std::span<const TypeAttributes> samples,
                                               std::size_t count);

}  // namespace aspect
