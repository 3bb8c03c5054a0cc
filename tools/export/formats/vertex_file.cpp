#include "tools/export/formats/vertex_file.h"

#include <fmt/format.h>

#include <iterator>
#include <unordered_set>

namespace aspect {
namespace {

std::vector<ListedVertex> read_vertices(TextLines& lines) {
  lines.need_next("the number of vertices");
  const std::int64_t count = lines.whole_word("number of vertices", 0, kMostId);
  lines.end_line();
  std::vector<ListedVertex> vertices;
  std::unordered_set<std::int64_t> ids;
  while (lines.next()) {
    vertices.push_back(read_vertex(lines));
    lines.end_line();
    if (!ids.insert(vertices.back().id).second)
      lines.fail(fmt::format("a second vertex with id {}", vertices.back().id));
  }
  if (static_cast<std::int64_t>(vertices.size()) != count)
    lines.fail(fmt::format("{} vertices, where the first line says {}", vertices.size(), count));
  return vertices;
}

}  // namespace

void append_vertex(const ListedVertex& vertex, int decimals, std::string& text) {
  const auto& [x, y, z] = vertex.direction;
  fmt::format_to(std::back_inserter(text), "3 {:.{}f} {:.{}f} {:.{}f} {} {}", x, decimals, y,
                 decimals, z, decimals, vertex.id, vertex.regions);
}

ListedVertex read_vertex(TextLines& lines) {
  ListedVertex vertex;
  lines.whole_word("number of coordinates", 3, 3);
  for (double& coordinate : vertex.direction) coordinate = lines.real_word("coordinate");
  if (!is_on_sphere(vertex.direction)) lines.fail("the vertex is not on the unit sphere");
  vertex.id = lines.whole_word("id", 0, kMostId);
  vertex.regions = lines.whole_word("number of regions", 0, kMostId);
  return vertex;
}

std::string vertices_text(const std::vector<ListedVertex>& vertices) {
  constexpr int kDecimals = 10;
  std::string text = fmt::format("{}\n", vertices.size());
  for (const ListedVertex& vertex : vertices) {
    append_vertex(vertex, kDecimals, text);
    text += '\n';
  }
  return text;
}

Result<std::vector<ListedVertex>> parse_vertices(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "the first line is the number of vertices, the others 3 X Y Z ID REGIONS",
                     read_vertices);
}

}  // namespace aspect
