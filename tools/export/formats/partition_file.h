// .part: the patches of the viewing sphere by the partition that they belong to (thesis A.2.6).
//
//   Partition 1
//   3 -0.951 -0.309 -0.000 23 3 3 -0.988 -0.156 -0.000 307 3 3 -0.964 -0.237 -0.117 308 3 3
//
// A patch on a line: its three vertices as in .vert, with three decimals, and the level of
// subdivision at which it was made. Partitions count from 1. A partition may have no patches: an
// aspect too thin for one, found by the views on its borders, which the thesis has none of.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/export/formats/vertex_file.h"

namespace aspect {

struct ListedPatch {
  std::array<ListedVertex, 3> corners;
  int level = 0;

  bool operator==(const ListedPatch&) const = default;
};

using Partition = std::vector<ListedPatch>;

std::string partitions_text(const std::vector<Partition>& partitions);
Result<std::vector<Partition>> parse_partitions(std::string_view text, std::string_view name);

}  // namespace aspect
