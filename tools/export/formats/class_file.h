// .class: the classes by the contour types of their regions (thesis A.2.10, 3.4.4 with the second
// scoring scheme).
//
//   1 3                          class, number of its regions
//   2 238 22:222 29:16           of a region: types, graphs, and of each type how many graphs
//   2 238 1:237 4:1              have the region as one
//   1 238 16:238
//
// Classes count from 1, as the partitions do, and types from 0, in the order of .means. Regions are
// in the order of their names.
#pragma once

#include <string>
#include <vector>

#include "tools/export/formats/text_lines.h"

namespace aspect {

struct TypeCount {
  std::int64_t type = 0, graphs = 0;

  bool operator==(const TypeCount&) const = default;
};

using RegionTypes = std::vector<TypeCount>;
using ListedClass = std::vector<RegionTypes>;

std::string classes_text(const std::vector<ListedClass>& classes);
Result<std::vector<ListedClass>> parse_classes(std::string_view text, std::string_view name);

}  // namespace aspect
