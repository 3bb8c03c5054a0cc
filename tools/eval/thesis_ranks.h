// The thesis's rank accumulation (tables 4.13, 4.15 to 4.18), for plots beside ours.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

struct RankShare {
  int rank = 0;
  double percent = 0;  // of the views whose right class is among so many
};

// By object, whose names are in capitals there.
using ThesisRanks = std::map<std::string, std::vector<RankShare>>;

// A table of commas whose first line names its columns: object and top1, top2, ..., in any order,
// others are passed over. Errors name file and line.
Result<ThesisRanks> read_thesis_ranks(const std::filesystem::path& file);

// Of an object by any case; null: the table has none.
const std::vector<RankShare>* ranks_of(const ThesisRanks& ranks, std::string_view object);

}  // namespace aspect
