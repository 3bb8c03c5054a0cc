// .chn8: the contours of a view as 8-way chain codes (thesis A.2.4). One line a contour, in the
// order of the graph's nodes, and -1 -1 at the end:
//
//   253 404 5AH15AH6A...
//   -1 -1
//
// Where the chain begins, and its steps, a number before a letter that is repeated. As the example
// shows, A is a step to the right and the letters go round against the clock: C is up, E left and G
// down. y points up: it is 0 in the last row of the picture. The last step, back to the beginning,
// is left out. Contours are run through with the clock, holes against it. A contour of a single
// pixel has no steps, and its line ends after the two numbers; the appendix has none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/export/formats/graph_node.h"

namespace aspect {

struct ContourChain {
  int x = 0, y = 0;
  std::string steps;  // a letter each; one fewer than pixels are passed

  bool operator==(const ContourChain&) const = default;
};

std::string chains_text(const std::vector<ContourChain>& chains);
Result<std::vector<ContourChain>> parse_chains(std::string_view text, std::string_view name);

// What a graph's node says of the region within a contour, its colour left out.
AttributeVector attributes_of(const ContourChain& chain);

}  // namespace aspect
