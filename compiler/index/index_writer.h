// The class index as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/index/index_contents.h"

namespace aspect {

struct IndexStatistics {
  std::size_t classes = 0;  // fewer than were found where the budget demands it
  std::size_t key_views = 0, contour_types = 0;
  double area_fraction = 0, area_assigned = 0;  // of the sphere, in the classes kept
  double key_view_spacing_deg = 0;
  std::size_t bytes = 0, golden_frame_bytes = 0;  // the latter of the former; 0: none
};

struct WrittenIndex {
  std::vector<std::uint8_t> bytes;
  IndexStatistics statistics;
};

// Keeps within options.max_index_bytes: see index_budget.h. One of the golden frame's candidates is
// added where the index answers it rightly: see golden_choice.h; room for it is kept free. The same
// contents give the same bytes.
WrittenIndex write_index(const IndexContents& contents);

}  // namespace aspect
