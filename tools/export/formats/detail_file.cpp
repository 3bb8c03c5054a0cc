#include "tools/export/formats/detail_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

constexpr std::int64_t kMostNodes = 100'000;

std::string read_view(TextLines& lines) {
  std::string view(lines.word("a view, as -0.163-0.984-0.074"));
  if (!direction_of_view_name(view)) lines.fail(excerpt_of(view) + " is no view");
  return view;
}

DetailedGraph read_detailed_graph(TextLines& lines) {
  DetailedGraph graph;
  lines.need_next("a graph");
  for (std::int64_t& id : graph.ids) id = lines.whole_word("id", 0, kMostId);
  graph.theta_deg = static_cast<int>(lines.whole_word("theta", -180, 180));
  graph.phi_deg = static_cast<int>(lines.whole_word("phi", -90, 90));
  lines.end_line();
  lines.need_next("the number of nodes");
  const std::int64_t count = lines.whole_word("number of nodes", 0, kMostNodes);
  graph.view = read_view(lines);
  lines.end_line();
  for (std::int64_t k = 0; k < count; ++k) {
    lines.need_next("a node");
    graph.nodes.push_back(read_node(lines));
    lines.end_line();
  }
  return graph;
}

std::vector<DetailGroup> read_details(TextLines& lines) {
  lines.need_next("the number of groups");
  const std::int64_t count = lines.whole_word("number of groups", 0, kMostId);
  lines.end_line();
  std::vector<DetailGroup> groups;
  for (std::int64_t number = 1; number <= count; ++number) {
    lines.need_next(fmt::format("group {} of {}", number, count));
    const std::int64_t graphs = lines.whole_word("number of graphs", 0, kMostId);
    lines.end_line();
    lines.need_next("the number of the group");
    lines.whole_word("number of the group", number, number);
    lines.end_line();
    DetailGroup& group = groups.emplace_back();
    for (std::int64_t k = 0; k < graphs; ++k) group.push_back(read_detailed_graph(lines));
  }
  if (lines.next()) lines.fail("something follows after the last group");
  return groups;
}

void append_graph(const DetailedGraph& graph, std::string& text) {
  fmt::format_to(std::back_inserter(text), "{} {} {} {}\n{} {}\n", graph.ids[0], graph.ids[1],
                 graph.theta_deg, graph.phi_deg, graph.nodes.size(), graph.view);
  for (const GraphNode& node : graph.nodes) {
    append_node(node, text);
    text += '\n';
  }
}

}  // namespace

Angles angles_of(const Direction3& direction) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const auto& [x, y, z] = direction;
  const double phi = portable_atan2(y, std::sqrt(x * x + z * z));
  return {static_cast<int>(portable_atan2(z, x) * kDegrees), static_cast<int>(phi * kDegrees)};
}

std::string details_text(const std::vector<DetailGroup>& groups) {
  std::string text = fmt::format("{}\n", groups.size());
  for (std::size_t k = 0; k < groups.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{}\n{}\n", groups[k].size(), k + 1);
    for (const DetailedGraph& graph : groups[k]) append_graph(graph, text);
  }
  return text;
}

Result<std::vector<DetailGroup>> parse_details(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "groups are GRAPHS, NUMBER and for each graph ID ID THETA PHI, NODES VIEW and "
                     "its nodes, a line each",
                     read_details);
}

}  // namespace aspect
