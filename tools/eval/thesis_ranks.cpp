#include "tools/eval/thesis_ranks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>

namespace aspect {
namespace {

constexpr std::size_t kMostBytes = 1U << 20U, kMostRank = 1000;

std::string in_capitals(std::string_view name) {
  std::string capitals(name);
  for (char& letter : capitals)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return capitals;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Where a table has what is needed.
struct Columns {
  std::optional<std::size_t> object;
  std::vector<std::pair<std::size_t, int>> ranks;  // column and rank, by rank
  std::size_t count = 0;
};

Columns columns_of(std::string_view head) {
  Columns columns;
  const auto fields = fields_of(head);
  columns.count = fields.size();
  for (std::size_t k = 0; k < fields.size(); ++k) {
    if (fields[k] == "object") columns.object = k;
    if (!fields[k].starts_with("top")) continue;
    const auto rank = number_in<int>(fields[k].substr(3));
    if (rank && *rank >= 1 && *rank <= static_cast<int>(kMostRank))
      columns.ranks.emplace_back(k, *rank);
  }
  std::sort(columns.ranks.begin(), columns.ranks.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  return columns;
}

// Empty: all is well.
std::string add_row(std::string_view line, const Columns& columns, ThesisRanks& ranks) {
  const auto fields = fields_of(line);
  if (fields.size() != columns.count)
    return fmt::format("{} fields, and the first line names {}; make them as many", fields.size(),
                       columns.count);
  std::vector<RankShare> shares;
  for (const auto& [column, rank] : columns.ranks) {
    const auto percent = number_in<double>(fields[column]);
    if (!percent || !(*percent >= 0 && *percent <= 100))
      return fmt::format("top{} is not a number from 0 to 100; correct it", rank);
    shares.push_back({rank, *percent});
  }
  ranks[in_capitals(fields[*columns.object])] = std::move(shares);
  return {};
}

}  // namespace

Result<ThesisRanks> read_thesis_ranks(const std::filesystem::path& file) {
  const auto failed = [&](std::size_t line, const std::string& what) {
    return Error{fmt::format("{}:{}: {}", file.native(), line, what)};
  };
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown))
    return Error{file.native() + ": is no file; give a table like object,top1,top2"};
  if (std::filesystem::file_size(file, unknown) > kMostBytes)
    return Error{file.native() + ": is larger than 1 MiB; give a table of ranks"};
  std::ifstream in(file);
  if (!in) return Error{file.native() + ": cannot be read; check its permissions"};
  std::string line;
  std::getline(in, line);
  const Columns columns = columns_of(line);
  if (!columns.object || columns.ranks.empty())
    return failed(1, "names no columns object and top1, top2, ...; give a table of ranks");
  ThesisRanks ranks;
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    if (line.empty() || line == "\r") continue;
    if (const std::string fault = add_row(line, columns, ranks); !fault.empty())
      return failed(number, fault);
  }
  if (ranks.empty()) return failed(1, "has no rows; give a table of ranks");
  return ranks;
}

const std::vector<RankShare>* ranks_of(const ThesisRanks& ranks, std::string_view object) {
  const auto found = ranks.find(in_capitals(object));
  return found == ranks.end() ? nullptr : &found->second;
}

}  // namespace aspect
