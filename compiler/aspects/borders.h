// Where the border between two aspects crosses an edge between two corners: found by bisection, as
// far as views go. Beyond the thesis, which leaves out every patch that straddles a border (3.4.1).
#pragma once

#include "compiler/aspects/observations.h"

namespace aspect {

// How finely an edge is bisected: the border is known to half of an edge's 16th.
inline constexpr int kBisections = 4;

// Takes views on the edges of patches that are not uniform, between ends that do not match, and
// adds what it finds to found.edge_views. Nothing where that would take more than about
// options.border_views; an edge whose end is nothing but background is left alone.
Result<Done> find_borders(const CompileOptions& options, Subdivision& found,
                          Observations& observations);

}  // namespace aspect
