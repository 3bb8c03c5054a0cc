#include "tools/export/formats/graph_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace aspect {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

// Nodes as they come, named alike each time.
class NodeTable {
 public:
  // Its name's place.
  std::size_t add(GraphNode node, const TextLines& lines) {
    const std::size_t place = place_of_name(node.name);
    const auto [known, is_new] = nodes_.try_emplace(place, node);
    if (!is_new && known->second != node)
      lines.fail("contour " + node.name + " has other attributes than in an entry before");
    return place;
  }

  std::vector<GraphNode> by_name() {
    std::vector<GraphNode> nodes;
    for (auto& [place, node] : nodes_) nodes.push_back(std::move(node));
    return nodes;
  }

  std::map<std::size_t, std::size_t> indices() const {
    std::map<std::size_t, std::size_t> index_of;
    for (const auto& [place, node] : nodes_) index_of.emplace(place, index_of.size());
    return index_of;
  }

 private:
  std::map<std::size_t, GraphNode> nodes_;  // by the name's place
};

// [[8i][@rep= 1 1]]
GraphArc read_code(TextLines& lines) {
  GraphArc arc;
  lines.expect("[");
  lines.expect("[");
  const std::size_t direction = kHexDigits.find(lines.peek());
  if (direction == std::string_view::npos) lines.fail("an arc has no direction from 0 to f");
  lines.expect(kHexDigits.substr(direction, 1));
  arc.direction = static_cast<int>(direction);
  for (const char kind : {'s', 'i', 'o'})
    if (arc.kind == ' ' && lines.accept({&kind, 1})) arc.kind = kind;
  lines.expect("]");
  lines.expect("[");
  lines.expect("@rep");
  lines.expect("=");
  for (int letters = arc.kind == ' ' ? 1 : 2; letters > 0; --letters)
    lines.whole("repetition", 1, 1);
  lines.expect("]");
  lines.expect("]");
  return arc;
}

RelationalGraph read_graph(TextLines& lines) {
  RelationalGraph graph;
  NodeTable nodes;
  std::set<std::pair<std::size_t, std::size_t>> known;
  for (std::int64_t entry = 1; lines.next(); ++entry) {
    lines.whole_word("number of the graph", 1, 1);
    lines.whole_word("number of the entry", entry, entry);
    lines.whole_word("number of arcs", 1, 1);
    lines.end_line();
    lines.need_next("an arc");
    const std::size_t from = nodes.add(read_node(lines), lines);
    if (lines.at_line_end()) continue;
    GraphArc arc = read_code(lines);
    arc.from = from;
    arc.to = nodes.add(read_node(lines), lines);
    lines.end_line();
    if (arc.from == arc.to) lines.fail("an arc from a contour to itself");
    if (!known.emplace(arc.from, arc.to).second)
      lines.fail("an arc between the same contours as one before");
    graph.arcs.push_back(arc);
  }
  const auto index_of = nodes.indices();
  for (GraphArc& arc : graph.arcs) {
    arc.from = index_of.at(arc.from);
    arc.to = index_of.at(arc.to);
  }
  graph.nodes = nodes.by_name();
  return graph;
}

}  // namespace

std::string graph_text(const RelationalGraph& graph) {
  std::string text;
  std::vector<bool> written(graph.nodes.size(), false);
  std::size_t entry = 0;
  const auto begin_entry = [&] { fmt::format_to(std::back_inserter(text), "1 {} 1\n", ++entry); };
  for (const GraphArc& arc : graph.arcs) {
    begin_entry();
    append_node(graph.nodes[arc.from], text);
    const bool has_kind = arc.kind != ' ';
    fmt::format_to(std::back_inserter(text), "[[{:x}{}][@rep= 1 {}]]", arc.direction,
                   has_kind ? std::string_view(&arc.kind, 1) : "", has_kind ? "1" : "");
    append_node(graph.nodes[arc.to], text);
    text += '\n';
    written[arc.from] = written[arc.to] = true;
  }
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    if (written[k]) continue;
    begin_entry();
    append_node(graph.nodes[k], text);
    text += '\n';
  }
  return text;
}

Result<RelationalGraph> parse_graph(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "an entry is 1 NUMBER 1 and on the next line NODE[[CODE][@rep= 1 ]]NODE",
                     read_graph);
}

}  // namespace aspect
