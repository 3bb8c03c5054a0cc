// The thesis's own models of its objects (Tables 4.2 to 4.10 and 4.12), to lay beside ours.
#pragma once

#include <string_view>
#include <vector>

namespace aspect {

struct ThesisRow {
  int level = 0;
  double threshold = 0, cluster_threshold = 0;  // in the units of the thesis's matcher
  int patches = 0, views = 0, match_calls = 0, clusters = 0;
  double area_fraction = 0;
};

// Of an object by its name, in capitals or not, in the order of the table; none where the thesis
// has no such object.
std::vector<ThesisRow> thesis_rows(std::string_view object);

}  // namespace aspect
