// What of an index's contents is left out, so that it fits into its bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/index/index_contents.h"

namespace aspect {

// Closer key views than this do not make the answer better: measured in tools/bench/RESULTS.md.
inline constexpr double kFinestKeyViewSpacing_deg = 5;

struct IndexSelection {
  std::size_t class_count = 0;      // the first of the contents' classes
  double key_view_spacing_deg = 0;  // least angle between key views of a class
  std::vector<std::uint8_t> map;    // of the viewing sphere: see sphere_map_writer.h
};

// Key views are taken farther apart until all classes fit; where one a class is still too much, the
// smallest classes are left out. `bytes_of` tells what an index of a selection takes.
IndexSelection select_within(const IndexContents& contents, std::size_t budget,
                             const std::function<std::size_t(const IndexSelection&)>& bytes_of);

}  // namespace aspect
