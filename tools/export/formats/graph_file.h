// .sgm: the attributed relational graph of a view (thesis A.2.2). Two lines an arc: three numbers,
// and the arc between its nodes, which are written out each time.
//
//   1 2 1
//   [A[@id=cftsrv;...]][[a][@rep= 1 ]][C[@id=cftsrv;...]]
//
// The arc's code is where the second node lies as seen from the first, in 16 directions as a
// compass has them: 0 up, 4 right, 8 down, c left (figures 3.3 and 3.5), and s, i or o where the
// first is superimposed on, lies inside or lies outside of (surrounds) the second. @rep tells for
// each letter of the code how often it was found: once.
//
// Centres of regions decide the direction, and the nodes' cg are those of contours: of BLOCKCYL2
// and TRUCK 7 to 8 arcs of 100 have a code that is one off from what cg says.
//
// What the appendix leaves open: the three numbers, which are taken for the graph's in the file,
// always 1, the arc's, from 1 on, and how many arcs the entry stands for, always 1. A node without
// arcs, which the appendix has no form for, is an entry of its own, after the arcs:
//
//   1 3 1
//   [D[@id=cftsrv;...]]
#pragma once

#include <string>
#include <vector>

#include "tools/export/formats/graph_node.h"

namespace aspect {

struct GraphArc {
  std::size_t from = 0, to = 0;  // into nodes
  int direction = 0;             // 0 to 15
  char kind = ' ';               // s, i, o, or a blank: apart

  bool operator==(const GraphArc&) const = default;
};

struct RelationalGraph {
  std::vector<GraphNode> nodes;  // by name
  std::vector<GraphArc> arcs;

  bool operator==(const RelationalGraph&) const = default;
};

std::string graph_text(const RelationalGraph& graph);
Result<RelationalGraph> parse_graph(std::string_view text, std::string_view name);

}  // namespace aspect
