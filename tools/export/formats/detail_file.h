// .det: the partition details (thesis A.2.7): the graphs of every view of a partition.
//
//   88                          groups
//   238                         graphs in this one
//   1                           its number, from 1 on
//   1 1 -155 -79                the graph's id, twice, theta and phi
//   3 -0.163-0.984-0.074        its number of nodes, and its view
//   [A[@id=na;...]]             the nodes
//
// As the example's numbers show, theta is atan2(z, x) and phi asin(y) of the view's direction, in
// degrees cut to whole ones. What the appendix leaves open: the ids count up through the file, from
// 1 on, and are the same twice. The contours have the names that they have in the partition (3.4.2)
// and are in their order: it is the file that canon.pl leaves, from which det2attr makes .attr, and
// without internal contours, as after remintdet.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/export/formats/graph_node.h"
#include "tools/export/formats/view_name.h"

namespace aspect {

struct DetailedGraph {
  std::array<std::int64_t, 2> ids{};
  int theta_deg = 0, phi_deg = 0;
  std::string view;  // its name
  std::vector<GraphNode> nodes;

  bool operator==(const DetailedGraph&) const = default;
};

using DetailGroup = std::vector<DetailedGraph>;

struct Angles {
  int theta_deg = 0, phi_deg = 0;
};
Angles angles_of(const Direction3& direction);

std::string details_text(const std::vector<DetailGroup>& groups);
Result<std::vector<DetailGroup>> parse_details(std::string_view text, std::string_view name);

}  // namespace aspect
