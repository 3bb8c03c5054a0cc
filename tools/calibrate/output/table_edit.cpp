#include "tools/calibrate/output/table_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "runtime/base/input_file.h"
#include "runtime/service/configuration.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/project/project_file.h"

namespace aspect {
namespace {

std::string_view trimmed(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t begin = line.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(kSpace) + 1 - begin);
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool is_header(std::string_view line, std::string_view table) {
  line = trimmed(line);
  if (!line.starts_with('[')) return false;
  const std::string_view name = line.substr(1, line.find(']') - 1);
  return trimmed(name) == table;
}

// What the line sets; empty: nothing.
std::string_view key_of(std::string_view line) {
  line = trimmed(line);
  const std::size_t equals = line.find('=');
  if (line.starts_with('#') || equals == std::string_view::npos) return {};
  return trimmed(line.substr(0, equals));
}

std::string comment_of(std::string_view line) {
  const std::size_t hash = line.find('#');
  return hash == std::string_view::npos ? std::string() : fmt::format("  {}", line.substr(hash));
}

}  // namespace

std::string with_values(std::string_view text, std::string_view table,
                        const std::vector<KeyValue>& values) {
  std::vector<std::string> lines = lines_of(text);
  auto begin = std::find_if(lines.begin(), lines.end(),
                            [&](const std::string& line) { return is_header(line, table); });
  if (begin == lines.end()) {
    if (!lines.empty() && !trimmed(lines.back()).empty()) lines.emplace_back();
    lines.push_back(fmt::format("[{}]", table));
    begin = lines.end() - 1;
  }
  auto first = static_cast<std::size_t>(begin - lines.begin()) + 1;
  std::size_t last = first;  // one past the last line that says something
  for (std::size_t k = first; k < lines.size() && !trimmed(lines[k]).starts_with('['); ++k)
    if (!trimmed(lines[k]).empty()) last = k + 1;
  for (const KeyValue& value : values) {
    const std::string line = fmt::format("{} = {}", value.key, value.value);
    std::size_t k = first;
    while (k < last && key_of(lines[k]) != value.key) ++k;
    if (k < last) {
      lines[k] = line + comment_of(lines[k]);
    } else {
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(last), line);
      ++last;
    }
  }
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

Result<std::string> read_toml_text(const std::filesystem::path& file) {
  constexpr std::uint64_t kMostBytes = 1U << 20U;
  InputFile input(file);
  if (input.is_missing()) return std::string();
  const auto bytes = input.size();
  if (!bytes) return Error{fmt::format("{}: {}; name another file", file.native(), input.reason())};
  if (*bytes > kMostBytes)
    return Error{file.native() +
                 ": larger than 1 MiB, which is no configuration; name another file"};
  std::string text(static_cast<std::size_t>(*bytes), '\0');
  if (!input.read(std::as_writable_bytes(std::span(text))))
    return Error{file.native() + ": cannot be read to its end; check the disk"};
  return text;
}

Result<Done> put_values(const std::filesystem::path& file, std::string_view head,
                        std::string_view table, const std::vector<KeyValue>& values) {
  const Result<std::string> there = read_toml_text(file);
  if (!there) return Error{there.error()};
  const bool is_new = trimmed(there.value()).empty();
  const std::string text =
      with_values(is_new ? head : std::string_view(there.value()), table, values);
  const auto configuration = parse_configuration(text, file.native());
  if (!configuration && (is_new || !parse_project(text, file))) return Error{configuration.error()};
  return write_whole_text(file, text);
}

}  // namespace aspect
