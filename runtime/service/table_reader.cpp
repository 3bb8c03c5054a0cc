#include "runtime/service/table_reader.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

// No longer than a message can bear.
std::string shortened(std::string_view text) {
  constexpr std::size_t kMost = 40;
  return std::string(text.substr(0, kMost)) + (text.size() > kMost ? "..." : "");
}

std::string describe(const toml::node& node) {
  if (const auto* number = node.as_integer()) return fmt::to_string(number->get());
  if (const auto* number = node.as_floating_point()) return fmt::to_string(number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (const auto* text = node.as_string()) return fmt::format("\"{}\"", shortened(text->get()));
  if (node.is_array()) return "an array";
  return node.is_table() ? "a table" : "a date or time";
}

std::optional<int> int_of(const toml::node& node, ClosedRange<int> range) {
  const auto* number = node.as_integer();
  if (number == nullptr || number->get() < range.least || number->get() > range.most) return {};
  return static_cast<int>(number->get());
}

}  // namespace

TableReader::TableReader(const toml::table& table, std::string file, std::string section)
    : table_(table), file_(std::move(file)), section_(std::move(section)) {}

const toml::node* TableReader::find(std::string_view key) {
  known_.push_back(key);
  return table_.get(key);
}

void TableReader::read(std::string_view key, ClosedRange<int> range, std::optional<int>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  if (const auto number = int_of(*node, range))
    value = number;
  else
    refuse(key, *node, fmt::format("a whole number from {} to {}", range.least, range.most));
}

void TableReader::read(std::string_view key, ClosedRange<double> range,
                       std::optional<double>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  // Not a number compares false with everything and so is refused too.
  const auto number = node->is_number() ? node->value<double>() : std::nullopt;
  if (number && *number >= range.least && *number <= range.most)
    value = number;
  else
    refuse(key, *node, fmt::format("a number from {} to {}", range.least, range.most));
}

void TableReader::read(std::string_view key, ClosedRange<double> range,
                       std::optional<float>& value) {
  std::optional<double> number;
  read(key, range, number);
  if (number) value = static_cast<float>(*number);
}

void TableReader::read(std::string_view key, std::optional<bool>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  if (const auto* truth = node->as_boolean())
    value = truth->get();
  else
    refuse(key, *node, "true or false");
}

void TableReader::read(std::string_view key, std::optional<std::string>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  if (const auto* text = node->as_string())
    value = text->get();
  else
    refuse(key, *node, "a text in quotes");
}

void TableReader::read(std::string_view key, ClosedRange<int> range,
                       std::optional<std::array<int, 4>>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const std::string wanted =
      fmt::format("[x, y, width, height], whole numbers from {} to {}", range.least, range.most);
  const toml::array* numbers = node->as_array();
  std::array<int, 4> read{};
  if (numbers == nullptr || numbers->size() != read.size()) return refuse(key, *node, wanted);
  for (std::size_t k = 0; k < read.size(); ++k) {
    const auto number = int_of((*numbers)[k], range);
    if (!number) return refuse(key, (*numbers)[k], wanted);
    read[k] = *number;
  }
  value = read;
}

void TableReader::read(std::string_view key, std::size_t count, ClosedRange<double> range,
                       std::optional<std::vector<double>>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const std::string wanted =
      fmt::format("an array of {} numbers from {} to {}", count, range.least, range.most);
  const toml::array* numbers = node->as_array();
  if (numbers == nullptr || numbers->size() != count) return refuse(key, *node, wanted);
  std::vector<double> read;
  for (const toml::node& element : *numbers) {
    const auto number = element.is_number() ? element.value<double>() : std::nullopt;
    if (!number || !(*number >= range.least && *number <= range.most))
      return refuse(key, element, wanted);
    read.push_back(*number);
  }
  value = std::move(read);
}

void TableReader::read(std::string_view key, ClosedRange<int> range, std::vector<int>& values) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const std::string wanted =
      fmt::format("an array of whole numbers from {} to {}", range.least, range.most);
  const toml::array* numbers = node->as_array();
  if (numbers == nullptr) return refuse(key, *node, wanted);
  for (const toml::node& element : *numbers) {
    const auto number = int_of(element, range);
    if (!number) return refuse(key, element, wanted);
    values.push_back(*number);
  }
}

void TableReader::read(std::string_view key, std::optional<std::vector<std::string>>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  constexpr std::string_view kWanted = "an array of texts in quotes";
  const toml::array* texts = node->as_array();
  if (texts == nullptr || texts->empty()) return refuse(key, *node, kWanted);
  std::vector<std::string> read;
  for (const toml::node& element : *texts) {
    const auto* text = element.as_string();
    if (text == nullptr) return refuse(key, element, kWanted);
    read.push_back(text->get());
  }
  value = std::move(read);
}

void TableReader::read(std::string_view key,
                       std::vector<std::pair<std::string, std::int64_t>>& numbers) {
  const toml::table* found = table(key);
  if (found == nullptr) return;
  // A table is sorted by its keys, but what is said first is to be done first.
  std::vector<std::pair<toml::source_position, std::pair<std::string, std::int64_t>>> read;
  for (const auto& [name, node] : *found) {
    const auto* number = node.as_integer();
    if (number == nullptr) return refuse(name.str(), node, "a whole number");
    read.push_back({name.source().begin, {std::string(name.str()), number->get()}});
  }
  std::sort(read.begin(), read.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [place, number] : read) numbers.push_back(std::move(number));
}

void TableReader::read(std::string_view key, std::span<const std::string_view> words,
                       std::optional<std::size_t>& value) {
  const toml::node* node = find(key);
  if (node == nullptr) return;
  const auto* text = node->as_string();
  const auto word = text ? std::find(words.begin(), words.end(), text->get()) : words.end();
  if (word == words.end())
    return refuse(key, *node, fmt::format("\"{}\"", fmt::join(words, "\" or \"")));
  value = static_cast<std::size_t>(word - words.begin());
}

const toml::table* TableReader::table(std::string_view key) {
  const toml::node* node = find(key);
  if (node != nullptr && !node->is_table()) refuse(key, *node, "a table");
  return node == nullptr ? nullptr : node->as_table();
}

std::vector<const toml::table*> TableReader::tables(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const std::string wanted = fmt::format("a list of tables, [[{}]]", key);
  const toml::array* elements = node->as_array();
  if (elements == nullptr) {
    refuse(key, *node, wanted);
    return {};
  }
  std::vector<const toml::table*> found;
  for (const toml::node& element : *elements) {
    if (element.is_table())
      found.push_back(element.as_table());
    else
      refuse(key, element, wanted);
  }
  return found;
}

void TableReader::fail(std::string_view key, std::string_view what) {
  const toml::node* node = table_.get(key);
  const toml::node& place = node == nullptr ? table_ : *node;
  fail_at(place.source().begin.line, fmt::format("{} {}", place_of(key), what));
}

void TableReader::require(std::string_view key) {
  if (table_.get(key) == nullptr) fail(key, "is missing; add it");
}

void TableReader::refuse(std::string_view key, const toml::node& node, std::string_view wanted) {
  fail_at(node.source().begin.line,
          fmt::format("{} is {}; it must be {}", place_of(key), describe(node), wanted));
}

std::string TableReader::place_of(std::string_view key) const {
  return section_.empty() ? std::string(key) : fmt::format("[{}] {}", section_, key);
}

void TableReader::fail_at(std::uint32_t line, std::string message) {
  if (error_ && error_line_ <= line) return;
  error_line_ = line;
  // Keys and texts of a file may hold line breaks, and a message is one line.
  std::replace_if(
      message.begin(), message.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  error_ = fmt::format("{}:{}: {}", file_, line, message);
}

std::optional<Error> TableReader::finish() {
  for (const auto& [key, node] : table_) {
    const std::string_view name = key.str();
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string_view nearest = nearest_word(name, known_);
    const std::string hint =
        nearest.empty() ? "remove it" : fmt::format("did you mean {}?", nearest);
    fail_at(key.source().begin.line,
            fmt::format("{} is not known here; {}", place_of(shortened(name)), hint));
  }
  if (!error_) return std::nullopt;
  return Error{*error_};
}

}  // namespace aspect
