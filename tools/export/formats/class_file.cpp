#include "tools/export/formats/class_file.h"

#include <fmt/format.h>

#include <iterator>
#include <unordered_set>

namespace aspect {
namespace {

constexpr std::int64_t kMostRegions = 100'000;

std::int64_t graphs_of(const RegionTypes& types) {
  std::int64_t sum = 0;
  for (const TypeCount& count : types) sum += count.graphs;
  return sum;
}

RegionTypes read_region(TextLines& lines) {
  RegionTypes types;
  std::unordered_set<std::int64_t> known;
  const std::int64_t count = lines.whole_word("number of types", 0, kMostId);
  const std::int64_t graphs = lines.whole_word("number of graphs", 0, kMostId);
  while (!lines.at_line_end()) {
    TypeCount type;
    type.type = lines.whole("type", 0, kMostId);
    lines.expect(":");
    type.graphs = lines.whole("number of graphs", 1, kMostId);
    if (!known.insert(type.type).second)
      lines.fail(fmt::format("type {} is there twice", type.type));
    types.push_back(type);
  }
  if (static_cast<std::int64_t>(types.size()) != count)
    lines.fail(fmt::format("{} types, where the line says {}", types.size(), count));
  if (graphs_of(types) != graphs)
    lines.fail(fmt::format("{} graphs, where the line says {}", graphs_of(types), graphs));
  return types;
}

std::vector<ListedClass> read_classes(TextLines& lines) {
  std::vector<ListedClass> classes;
  while (lines.next()) {
    const auto number = static_cast<std::int64_t>(classes.size()) + 1;
    lines.whole_word("number of the class", number, number);
    const std::int64_t regions = lines.whole_word("number of regions", 0, kMostRegions);
    lines.end_line();
    ListedClass& listed = classes.emplace_back();
    for (std::int64_t k = 0; k < regions; ++k) {
      lines.need_next(fmt::format("region {} of {}", k + 1, regions));
      listed.push_back(read_region(lines));
    }
  }
  return classes;
}

}  // namespace

std::string classes_text(const std::vector<ListedClass>& classes) {
  std::string text;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    fmt::format_to(std::back_inserter(text), "{} {}\n", c + 1, classes[c].size());
    for (const RegionTypes& types : classes[c]) {
      fmt::format_to(std::back_inserter(text), "{} {}", types.size(), graphs_of(types));
      for (const TypeCount& count : types)
        fmt::format_to(std::back_inserter(text), " {}:{}", count.type, count.graphs);
      text += '\n';
    }
  }
  return text;
}

Result<std::vector<ListedClass>> parse_classes(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "a class is CLASS REGIONS, from 1 on, and for each region a line TYPES GRAPHS "
                     "TYPE:GRAPHS...",
                     read_classes);
}

}  // namespace aspect
