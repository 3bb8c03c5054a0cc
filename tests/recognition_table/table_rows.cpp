#include "tests/recognition_table/table_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/score/truth_table.h"

namespace aspect {
namespace {

constexpr const char* kColumns =
    "frames_of,indexes_of,level,frames,things,least_right,most_false,least_within_20,"
    "largest_median_deg,slowest_ratio";
constexpr std::size_t kColumnCount = 10;

}  // namespace

Result<std::vector<TableRow>> read_table(const std::filesystem::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text) return Error{text.error()};
  std::vector<TableRow> rows;
  bool headed = false;
  for (const CsvRow& row : csv_rows(text.value())) {
    const auto wrong = [&](const std::string& what) {
      return Error{fmt::format("{}:{}: {}", file.native(), row.line, what)};
    };
    if (row.fields.front().starts_with('#')) continue;
    if (!std::exchange(headed, true)) {
      if (fmt::format("{}", fmt::join(row.fields, ",")) != kColumns)
        return wrong(fmt::format("the first row must be {}", kColumns));
      continue;
    }
    if (row.fields.size() != kColumnCount)
      return wrong(fmt::format("{} fields; there are {}", row.fields.size(), kColumnCount));
    std::vector<double> numbers;
    for (std::size_t k = 2; k < kColumnCount; ++k) {
      const auto number = finite_number(row.fields[k]);
      if (!number || *number < 0)
        return wrong(fmt::format("{} is not a number of 0 or more", row.fields[k]));
      numbers.push_back(*number);
    }
    const auto count = [&](std::size_t k) { return static_cast<std::size_t>(numbers[k]); };
    rows.push_back({row.fields[0],
                    row.fields[1],
                    static_cast<int>(numbers[0]),
                    {count(1), count(2), count(3), count(4), count(5), numbers[6], numbers[7]}});
  }
  if (rows.empty()) return Error{fmt::format("{}: has no rows", file.native())};
  return rows;
}

std::string table_text(const std::vector<TableRow>& rows) {
  std::string text =
      "# How well sets of frames are recognised, at the least: recognition_table_test holds it.\n"
      "# level: that the indexes are compiled at, the same for all rows of a folder of indexes.\n"
      "# things: objects to be named, and frames in which nothing is to be named; least_right of\n"
      "# them, which is what a better recogniser raises to things. most_false: things named where\n"
      "# no such object is, which it lowers to 0. Rows whose frames show none of their indexes'\n"
      "# objects say how often nothing is named: hardly ever today.\n"
      "# slowest_ratio: the median frame's time to that of reading every byte of a frame.\n"
      "# Written anew, with something to spare, by the target refresh_recognition_table.\n";
  text += kColumns;
  text += '\n';
  for (const TableRow& row : rows) {
    const SetFigures& limits = row.limits;
    text += fmt::format("{},{},{},{},{},{},{},{},{:.1f},{:.0f}\n", row.frames, row.indexes,
                        row.level, limits.frames, limits.things, limits.right, limits.false_ones,
                        limits.within_20, limits.median_deg, limits.time_ratio);
  }
  return text;
}

std::vector<std::string> broken_limits(const SetFigures& limits, const SetFigures& reached) {
  std::vector<std::string> broken;
  const auto hold = [&](bool holds, const char* what, double is, double limit) {
    if (!holds) broken.push_back(fmt::format("{} {:.6g}; the table has {:.6g}", what, is, limit));
  };
  const auto number = [](std::size_t count) { return static_cast<double>(count); };
  hold(reached.frames == limits.frames, "frames:", number(reached.frames), number(limits.frames));
  hold(reached.things == limits.things, "things:", number(reached.things), number(limits.things));
  hold(reached.right >= limits.right, "right:", number(reached.right), number(limits.right));
  hold(reached.false_ones <= limits.false_ones, "falsely named:", number(reached.false_ones),
       number(limits.false_ones));
  hold(reached.within_20 >= limits.within_20, "views within 20 degrees:", number(reached.within_20),
       number(limits.within_20));
  hold(reached.median_deg <= limits.median_deg, "median error in degrees:", reached.median_deg,
       limits.median_deg);
  hold(reached.time_ratio <= limits.time_ratio,
       "median time to reading every byte:", reached.time_ratio, limits.time_ratio);
  return broken;
}

SetFigures limits_from(const SetFigures& reached) {
  constexpr double kFewer = 0.05, kMore = 0.1, kLargerError = 1.5, kSlower = 2;
  constexpr double kLargest_deg = 180;
  const auto share = [](std::size_t count, double part) {
    return static_cast<std::size_t>(part * static_cast<double>(count));
  };
  SetFigures limits = reached;
  // What is perfect has to stay so.
  if (reached.right < reached.things) limits.right -= share(reached.right, kFewer);
  if (reached.within_20 < reached.right) limits.within_20 -= share(reached.within_20, kFewer);
  limits.false_ones += share(reached.false_ones, kMore);
  limits.median_deg =
      std::min(kLargest_deg, std::ceil(10 * kLargerError * reached.median_deg) / 10);
  limits.time_ratio = std::ceil(kSlower * reached.time_ratio);
  return limits;
}

}  // namespace aspect
