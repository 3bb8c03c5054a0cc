// .attr: the attribute vectors of all regions of all graphs of a .det (thesis A.2.8).
//
//   80515 17060                                             regions, graphs
//   1 1 0 17959 21021 0 11183 777 255 326 158 63 255
//
// A region on a line: its partition and its graph in that, from 1 on, its number in the graph, from
// 0 on, and area, four moments, centre x and y, red, green and blue: see graph_node.h.
#pragma once

#include <string>
#include <vector>

#include "tools/export/formats/detail_file.h"

namespace aspect {

struct AttributeRow {
  std::int64_t partition = 0, graph = 0, region = 0;
  AttributeVector attributes{};

  bool operator==(const AttributeRow&) const = default;
};

struct AttributeTable {
  std::int64_t graphs = 0;  // those without regions have no rows
  std::vector<AttributeRow> rows;

  bool operator==(const AttributeTable&) const = default;
};

// What det2attr does (A.1.7).
AttributeTable attributes_of(const std::vector<DetailGroup>& groups);

std::string attributes_text(const AttributeTable& table);
Result<AttributeTable> parse_attributes(std::string_view text, std::string_view name);

// Ten numbers with blanks before them, and back.
void append_attributes(const AttributeVector& attributes, std::string& text);
AttributeVector read_attributes(TextLines& lines);

}  // namespace aspect
