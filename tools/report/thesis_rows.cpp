#include "tools/report/thesis_rows.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>

#include "tools/report/embedded_files.h"

namespace aspect {

std::vector<ThesisRow> thesis_rows(std::string_view object) {
  std::vector<ThesisRow> rows;
  std::istringstream table{std::string(kThesisStatistics)};
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with('#') || line.starts_with("object")) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    std::string name;
    ThesisRow row;
    words >> name >> row.level >> row.threshold >> row.cluster_threshold >> row.patches >>
        row.views >> row.match_calls >> row.clusters >> row.area_fraction;
    const auto is_same = [](unsigned char a, unsigned char b) {
      return std::toupper(a) == std::toupper(b);
    };
    if (words && std::equal(name.begin(), name.end(), object.begin(), object.end(), is_same))
      rows.push_back(row);
  }
  return rows;
}

}  // namespace aspect
