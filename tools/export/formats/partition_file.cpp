#include "tools/export/formats/partition_file.h"

#include <fmt/format.h>

#include <iterator>

namespace aspect {
namespace {

constexpr int kMostLevel = 20;

ListedPatch read_patch(TextLines& lines) {
  ListedPatch patch;
  for (ListedVertex& corner : patch.corners) corner = read_vertex(lines);
  patch.level = static_cast<int>(lines.whole_word("level", 0, kMostLevel));
  lines.end_line();
  return patch;
}

std::vector<Partition> read_partitions(TextLines& lines) {
  std::vector<Partition> partitions;
  while (lines.next()) {
    if (lines.accept("Partition")) {
      const auto number = static_cast<std::int64_t>(partitions.size()) + 1;
      lines.whole_word("number of the partition", number, number);
      lines.end_line();
      partitions.emplace_back();
      continue;
    }
    if (partitions.empty()) lines.fail("a patch before the first partition");
    partitions.back().push_back(read_patch(lines));
  }
  return partitions;
}

}  // namespace

std::string partitions_text(const std::vector<Partition>& partitions) {
  constexpr int kDecimals = 3;
  std::string text;
  for (std::size_t k = 0; k < partitions.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "Partition {}\n", k + 1);
    for (const ListedPatch& patch : partitions[k]) {
      for (const ListedVertex& corner : patch.corners) {
        append_vertex(corner, kDecimals, text);
        text += ' ';
      }
      fmt::format_to(std::back_inserter(text), "{}\n", patch.level);
    }
  }
  return text;
}

Result<std::vector<Partition>> parse_partitions(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "a line is Partition NUMBER, from 1 on, or three times 3 X Y Z ID REGIONS, "
                     "then LEVEL",
                     read_partitions);
}

}  // namespace aspect
