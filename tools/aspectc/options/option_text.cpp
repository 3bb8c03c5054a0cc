#include "tools/aspectc/options/option_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace aspect {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// The whole text as a number within the range; nan is in none.
template <typename Number>
std::optional<OptionValue> number_of(std::string_view text, ClosedRange<Number> range) {
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!(number >= range.least && number <= range.most)) return std::nullopt;
  return number;
}

std::optional<OptionValue> truth_of(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  return std::nullopt;
}

std::optional<OptionValue> word_of(std::string_view text, std::span<const std::string_view> words) {
  const auto word = std::find(words.begin(), words.end(), text);
  if (word == words.end()) return std::nullopt;
  return static_cast<int>(word - words.begin());
}

std::optional<OptionValue> numbers_of(std::string_view text, const NumbersForm& form) {
  std::vector<double> numbers;
  for (;;) {
    const std::size_t comma = text.find(',');
    const auto number = number_of<double>(text.substr(0, comma), form.range);
    if (!number) return std::nullopt;
    numbers.push_back(std::get<double>(*number));
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  if (numbers.size() != form.count) return std::nullopt;
  return numbers;
}

// TOML tells 1.0 from 1, and either will do for a number.
std::string number_text(double number) {
  constexpr double kPlain = 1e15;
  if (std::abs(number) < kPlain && number == std::floor(number))
    return fmt::format("{:.0f}", number);
  return fmt::to_string(number);
}

}  // namespace

std::string toml_text(const Option& option, const OptionValue& value) {
  if (const auto* form = std::get_if<WordForm>(&option.form))
    return fmt::format("\"{}\"", form->words[static_cast<std::size_t>(std::get<int>(value))]);
  return std::visit(Overloaded{[](bool truth) { return std::string(truth ? "true" : "false"); },
                               [](int number) { return fmt::to_string(number); },
                               [](double number) { return number_text(number); },
                               [](const std::vector<double>& numbers) {
                                 std::vector<std::string> texts;
                                 for (const double number : numbers)
                                   texts.push_back(number_text(number));
                                 return fmt::format("[{}]", fmt::join(texts, ", "));
                               }},
                    value);
}

std::string form_text(const OptionForm& form) {
  return std::visit(
      Overloaded{[](const TruthForm&) { return std::string("true or false"); },
                 [](const WholeForm& f) {
                   return fmt::format("a whole number from {} to {}", f.range.least, f.range.most);
                 },
                 [](const NumberForm& f) {
                   return fmt::format("a number from {} to {}", f.range.least, f.range.most);
                 },
                 [](const NumbersForm& f) {
                   return fmt::format("{} numbers from {} to {}", f.count, f.range.least,
                                      f.range.most);
                 },
                 [](const WordForm& f) { return fmt::format("{}", fmt::join(f.words, " or ")); }},
      form);
}

Result<OptionValue> parse_value(const OptionForm& form, std::string_view text) {
  const std::optional<OptionValue> value =
      std::visit(Overloaded{[&](const TruthForm&) { return truth_of(text); },
                            [&](const WholeForm& f) { return number_of<int>(text, f.range); },
                            [&](const NumberForm& f) { return number_of<double>(text, f.range); },
                            [&](const NumbersForm& f) { return numbers_of(text, f); },
                            [&](const WordForm& f) { return word_of(text, f.words); }},
                 form);
  if (value) return *value;
  return Error{fmt::format("{} is not {}", text, form_text(form))};
}

std::optional<OptionValue> read_value(TableReader& reader, const Option& option) {
  const std::string_view key = option.text.key;
  const auto read = [](const auto& wanted) -> std::optional<OptionValue> {
    if (!wanted) return std::nullopt;
    return *wanted;
  };
  return std::visit(Overloaded{[&](const TruthForm&) {
                                 std::optional<bool> value;
                                 reader.read(key, value);
                                 return read(value);
                               },
                               [&](const WholeForm& f) {
                                 std::optional<int> value;
                                 reader.read(key, f.range, value);
                                 return read(value);
                               },
                               [&](const NumberForm& f) {
                                 std::optional<double> value;
                                 reader.read(key, f.range, value);
                                 return read(value);
                               },
                               [&](const NumbersForm& f) {
                                 std::optional<std::vector<double>> value;
                                 reader.read(key, f.count, f.range, value);
                                 return read(value);
                               },
                               [&](const WordForm& f) -> std::optional<OptionValue> {
                                 std::optional<std::size_t> value;
                                 reader.read(key, f.words, value);
                                 if (!value) return std::nullopt;
                                 return static_cast<int>(*value);
                               }},
                    option.form);
}

std::string flag_name(const Option& option) {
  return std::string(option.text.flag.substr(0, option.text.flag.find(',')));
}

std::string key_name(const Option& option) {
  return fmt::format("[{}] {}", option.text.table, option.text.key);
}

}  // namespace aspect
