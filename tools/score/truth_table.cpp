#include "tools/score/truth_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>

namespace aspect {
namespace {

constexpr std::array<std::string_view, 8> kNumbers = {"vx", "vy", "vz", "x",
                                                      "y",  "w",  "h",  "visible"};

struct Columns {
  std::size_t file = 0, object = 0, count = 0;
  std::array<std::size_t, kNumbers.size()> numbers{};
};

Result<Columns> find_columns(const CsvRow& head, const std::string& name) {
  const auto place = [&](std::string_view column) {
    return static_cast<std::size_t>(std::find(head.fields.begin(), head.fields.end(), column) -
                                    head.fields.begin());
  };
  Columns columns{place("file"), place("object"), head.fields.size(), {}};
  std::transform(kNumbers.begin(), kNumbers.end(), columns.numbers.begin(), place);
  std::vector<std::string_view> needed = {"file", "object"};
  needed.insert(needed.end(), kNumbers.begin(), kNumbers.end());
  for (const std::string_view column : needed)
    if (place(column) == columns.count)
      return Error{fmt::format("{}:{}: no column {}; the first line has to name the columns", name,
                               head.line, column)};
  return columns;
}

Result<TrueObject> read_object(const CsvRow& row, const Columns& columns, const std::string& name) {
  std::array<double, kNumbers.size()> n{};
  for (std::size_t k = 0; k < n.size(); ++k) {
    const std::string& field = row.fields[columns.numbers[k]];
    const auto number = finite_number(field);
    if (!number)
      return Error{fmt::format("{}:{}: {} is \"{}\"; a number was expected", name, row.line,
                               kNumbers[k], field)};
    n[k] = *number;
  }
  const Eigen::Vector3d view(n[0], n[1], n[2]);
  if (!(std::abs(view.norm() - 1) < 1e-3))
    return Error{
        fmt::format("{}:{}: vx, vy, vz have a length of {:.4g}; a unit vector was expected", name,
                    row.line, view.norm())};
  return TrueObject{row.fields[columns.object], view.normalized(), {n[3], n[4], n[5], n[6]}, n[7]};
}

}  // namespace

Result<std::string> read_text(const std::filesystem::path& file) {
  std::error_code code;
  const std::string& name = file.native();
  if (!std::filesystem::exists(file, code)) return Error{name + ": no such file; check the path"};
  if (std::filesystem::is_directory(file, code))
    return Error{name + ": a folder; a file was expected"};
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) return Error{name + ": cannot be read; check its permissions"};
  return text;
}

std::optional<double> finite_number(std::string_view field) {
  double number = 0;
  const char* end = field.data() + field.size();
  const auto parsed = std::from_chars(field.data(), end, number);
  if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::vector<CsvRow> csv_rows(std::string_view text) {
  std::vector<CsvRow> rows;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
    if (rest.empty()) continue;
    CsvRow row{line, {}};
    for (;;) {
      const std::size_t comma = rest.find(',');
      row.fields.emplace_back(rest.substr(0, comma));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<std::vector<TrueFrame>> parse_truth(std::string_view text, const std::string& name) {
  const std::vector<CsvRow> rows = csv_rows(text);
  if (rows.size() < 2) return Error{name + ": holds no frames; one row an object was expected"};
  const Result<Columns> found = find_columns(rows.front(), name);
  if (!found) return Error{found.error()};
  const Columns& columns = found.value();
  std::vector<TrueFrame> frames;
  std::map<std::string, std::size_t> place_of;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    if (row->fields.size() != columns.count)
      return Error{fmt::format("{}:{}: {} fields; {} were expected", name, row->line,
                               row->fields.size(), columns.count)};
    const auto [place, is_new] = place_of.try_emplace(row->fields[columns.file], frames.size());
    if (is_new) frames.push_back({place->first, {}});
    if (row->fields[columns.object].empty()) continue;
    Result<TrueObject> object = read_object(*row, columns, name);
    if (!object) return Error{object.error()};
    frames[place->second].objects.push_back(std::move(object).value());
  }
  return frames;
}

Result<std::vector<TrueFrame>> read_truth(const std::filesystem::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text) return Error{text.error()};
  return parse_truth(text.value(), file.native());
}

}  // namespace aspect
