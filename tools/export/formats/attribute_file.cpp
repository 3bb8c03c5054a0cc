#include "tools/export/formats/attribute_file.h"

#include <fmt/format.h>

#include <iterator>
#include <set>

namespace aspect {
namespace {

AttributeTable read_attribute_table(TextLines& lines) {
  AttributeTable table;
  lines.need_next("the numbers of regions and graphs");
  const std::int64_t regions = lines.whole_word("number of regions", 0, kMostId);
  table.graphs = lines.whole_word("number of graphs", 0, kMostId);
  lines.end_line();
  std::set<std::pair<std::int64_t, std::int64_t>> graphs;
  while (lines.next()) {
    AttributeRow row;
    row.partition = lines.whole_word("partition", 1, kMostId);
    row.graph = lines.whole_word("graph", 1, kMostId);
    row.region = lines.whole_word("region", 0, kMostId);
    row.attributes = read_attributes(lines);
    lines.end_line();
    if (table.rows.empty() || table.rows.back().graph != row.graph ||
        table.rows.back().partition != row.partition)
      graphs.emplace(row.partition, row.graph);
    table.rows.push_back(row);
  }
  if (static_cast<std::int64_t>(table.rows.size()) != regions)
    lines.fail(fmt::format("{} regions, where the first line says {}", table.rows.size(), regions));
  if (static_cast<std::int64_t>(graphs.size()) > table.graphs)
    lines.fail(fmt::format("{} graphs, where the first line says {}", graphs.size(), table.graphs));
  return table;
}

}  // namespace

AttributeTable attributes_of(const std::vector<DetailGroup>& groups) {
  AttributeTable table;
  for (std::size_t p = 0; p < groups.size(); ++p) {
    for (std::size_t g = 0; g < groups[p].size(); ++g) {
      const std::vector<GraphNode>& nodes = groups[p][g].nodes;
      for (std::size_t r = 0; r < nodes.size(); ++r)
        table.rows.push_back({static_cast<std::int64_t>(p) + 1, static_cast<std::int64_t>(g) + 1,
                              static_cast<std::int64_t>(r), nodes[r].attributes});
    }
    table.graphs += static_cast<std::int64_t>(groups[p].size());
  }
  return table;
}

void append_attributes(const AttributeVector& attributes, std::string& text) {
  for (std::size_t k = 0; k < attributes.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{}{}", k > 0 ? " " : "", attributes[k]);
}

AttributeVector read_attributes(TextLines& lines) {
  AttributeVector attributes{};
  for (std::int64_t& value : attributes)
    value = lines.whole_word("attribute", -kMostAttribute, kMostAttribute);
  return attributes;
}

std::string attributes_text(const AttributeTable& table) {
  std::string text = fmt::format("{} {}\n", table.rows.size(), table.graphs);
  for (const AttributeRow& row : table.rows) {
    fmt::format_to(std::back_inserter(text), "{} {} {} ", row.partition, row.graph, row.region);
    append_attributes(row.attributes, text);
    text += '\n';
  }
  return text;
}

Result<AttributeTable> parse_attributes(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "the first line is REGIONS GRAPHS, the others PARTITION GRAPH REGION and ten "
                     "attributes",
                     read_attribute_table);
}

}  // namespace aspect
