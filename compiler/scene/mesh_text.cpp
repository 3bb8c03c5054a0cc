#include "compiler/scene/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace aspect {

std::string shown(std::string_view word) {
  std::string text;
  for (const char letter : word.substr(0, 40))
    text += letter >= ' ' && letter <= '~' ? letter : '?';
  return text;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kSpaces = " \t\r\n\v\f";
  std::vector<std::string_view> words;
  for (std::size_t end = 0;;) {
    const std::size_t begin = line.find_first_not_of(kSpaces, end);
    if (begin == std::string_view::npos) return words;
    end = std::min(line.find_first_of(kSpaces, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
  }
}

std::string_view rest_of_line(std::string_view line, std::string_view word) {
  constexpr std::string_view kSpaces = " \t\r\n\v\f";
  std::string_view rest = line.substr(static_cast<std::size_t>(word.end() - line.begin()));
  rest.remove_prefix(std::min(rest.find_first_not_of(kSpaces), rest.size()));
  rest.remove_suffix(rest.size() - (rest.find_last_not_of(kSpaces) + 1));
  if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"')
    rest = rest.substr(1, rest.size() - 2);
  return rest;
}

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return lower;
}

std::string_view with_line_feeds(std::string_view text, std::string& held) {
  if (text.find('\n') != std::string_view::npos || text.find('\r') == std::string_view::npos)
    return text;
  held = text;
  std::replace(held.begin(), held.end(), '\r', '\n');
  return held;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::string_view MeshText::take_line() {
  if (at_end()) return {};
  const std::size_t begin = position_;
  const std::size_t end = std::min(text_.find('\n', begin), text_.size());
  position_ = end + 1;
  ++line_;
  std::string_view line = text_.substr(begin, end - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::vector<std::string_view> MeshText::take_words(std::string_view what) {
  while (!at_end()) {
    const std::string_view line = take_line();
    std::vector<std::string_view> words = words_of(line.substr(0, line.find('#')));
    if (!words.empty()) return words;
  }
  fail(fmt::format("ends where {} should be; export it again", what));
}

double MeshText::number(std::string_view word) const {
  double value = 0;
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
    fail(fmt::format("'{}' is not a finite number; export it again", shown(word)));
  return value;
}

std::size_t MeshText::count(std::string_view word, std::size_t most) const {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || value > most)
    fail(fmt::format("'{}' is not a whole number within 0 .. {}", shown(word), most));
  return value;
}

}  // namespace aspect
