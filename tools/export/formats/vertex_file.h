// .vert: the vertices of the viewing sphere (thesis A.2.5): how many, and a line for each,
//
//   3 -0.9998072406 -0.0196336858 -0.0000000713 12743 2
//
// the number of coordinates, the coordinates, an id of the vertex, and the number of regions that
// are seen from there. As in the example, vertices are in the order of their coordinates. The
// regions are those that matching works with: the external contours.
#pragma once

#include <string>
#include <vector>

#include "tools/export/formats/text_lines.h"
#include "tools/export/formats/view_name.h"

namespace aspect {

struct ListedVertex {
  Direction3 direction{};
  std::int64_t id = 0, regions = 0;

  bool operator==(const ListedVertex&) const = default;
};

// 3 x y z id nr
void append_vertex(const ListedVertex& vertex, int decimals, std::string& text);
ListedVertex read_vertex(TextLines& lines);

std::string vertices_text(const std::vector<ListedVertex>& vertices);
Result<std::vector<ListedVertex>> parse_vertices(std::string_view text, std::string_view name);

}  // namespace aspect
