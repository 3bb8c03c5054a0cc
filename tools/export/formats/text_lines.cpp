#include "tools/export/formats/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "runtime/base/input_file.h"

namespace aspect {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

bool is_blank(char c) {
  return kBlanks.find(c) != std::string_view::npos;
}

std::string_view without_end_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// std::from_chars knows no plus.
std::string_view without_plus(std::string_view word) {
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return has_plus ? word.substr(1) : word;
}

}  // namespace

std::string excerpt_of(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown(text.substr(0, kLongest));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return fmt::format("'{}{}'", shown, text.size() > kLongest ? "..." : "");
}

TextLines::TextLines(std::string_view text, std::string_view name, std::string_view remedy)
    : text_(text), name_(name), remedy_(remedy) {}

std::string_view TextLines::take_line() {
  const std::size_t end = std::min(text_.find('\n'), text_.size());
  const std::string_view line = text_.substr(0, end);
  text_.remove_prefix(std::min(end + 1, text_.size()));
  ++lines_taken_;
  return without_end_blanks(line);
}

bool TextLines::next() {
  while (!text_.empty()) {
    line_ = take_line();
    first_line_ = lines_taken_;
    if (line_.ends_with('\\')) {
      joined_.clear();
      while (line_.ends_with('\\')) {
        joined_ += line_.substr(0, line_.size() - 1);
        joined_ += ' ';
        line_ = text_.empty() ? std::string_view() : take_line();
      }
      joined_ += line_;
      line_ = joined_;
    }
    skip_blanks();
    if (!line_.empty()) return true;
  }
  line_ = {};
  first_line_ = lines_taken_ + 1;
  return false;
}

void TextLines::need_next(std::string_view what) {
  if (!next()) fail(fmt::format("the file ends where {} should follow", what));
}

void TextLines::skip_blanks() {
  while (!line_.empty() && is_blank(line_.front())) line_.remove_prefix(1);
}

bool TextLines::at_line_end() {
  skip_blanks();
  return line_.empty();
}

void TextLines::end_line() {
  if (!at_line_end()) fail(fmt::format("{} is too much on the line", excerpt_of(line_)));
}

std::string_view TextLines::next_word() {
  skip_blanks();
  const auto end = std::find_if(line_.begin(), line_.end(), is_blank);
  const std::string_view word = line_.substr(0, static_cast<std::size_t>(end - line_.begin()));
  line_.remove_prefix(word.size());
  return word;
}

std::string_view TextLines::word(std::string_view what) {
  const std::string_view word = next_word();
  if (word.empty()) fail(fmt::format("the line ends where {} should follow", what));
  return word;
}

std::int64_t TextLines::whole_word(std::string_view what, std::int64_t least, std::int64_t most) {
  const std::string_view found = word(what), digits = without_plus(found);
  std::int64_t number = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number =
      parsed.ec == std::errc() && parsed.ptr == digits.data() + digits.size() && number >= least;
  if (!is_number || number > most)
    fail(fmt::format("{} is no {}, a whole number from {} to {}", excerpt_of(found), what, least,
                     most));
  return number;
}

double TextLines::real_word(std::string_view what) {
  const std::string_view found = word(what), digits = without_plus(found);
  double number = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (parsed.ec != std::errc() || parsed.ptr != digits.data() + digits.size() ||
      !std::isfinite(number))
    fail(fmt::format("{} is no {}, a number", excerpt_of(found), what));
  return number;
}

bool TextLines::accept(std::string_view literal) {
  skip_blanks();
  if (!line_.starts_with(literal)) return false;
  line_.remove_prefix(literal.size());
  return true;
}

void TextLines::expect(std::string_view literal) {
  if (accept(literal)) return;
  fail(line_.empty() ? fmt::format("the line ends where '{}' should follow", literal)
                     : fmt::format("{} stands where '{}' should", excerpt_of(line_), literal));
}

std::int64_t TextLines::whole(std::string_view what, std::int64_t least, std::int64_t most) {
  skip_blanks();
  std::int64_t number = 0;
  const auto parsed = std::from_chars(line_.data(), line_.data() + line_.size(), number);
  if (parsed.ec != std::errc() || number < least || number > most)
    fail(fmt::format("{} stands where a {} from {} to {} should", excerpt_of(line_), what, least,
                     most));
  line_.remove_prefix(static_cast<std::size_t>(parsed.ptr - line_.data()));
  return number;
}

std::string_view TextLines::run_of(std::string_view characters, std::string_view what) {
  skip_blanks();
  const std::size_t end = std::min(line_.find_first_not_of(characters), line_.size());
  if (end == 0) fail(fmt::format("{} stands where {} should", excerpt_of(line_), what));
  const std::string_view run = line_.substr(0, end);
  line_.remove_prefix(end);
  return run;
}

char TextLines::peek() {
  skip_blanks();
  return line_.empty() ? '\0' : line_.front();
}

void TextLines::fail(const std::string& what) const {
  fail_at(first_line_, what);
}

void TextLines::fail_at(std::size_t line, const std::string& what) const {
  throw MalformedText{fmt::format("{}:{}: {}; {}", name_, line, what, remedy_)};
}

Result<std::string> read_text_file(const std::filesystem::path& file) {
  constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;
  InputFile input(file);
  const auto size = input.size();
  if (!size)
    return Error{
        fmt::format("{}: cannot be read ({}); check the path", file.string(), input.reason())};
  if (*size > kMostBytes)
    return Error{
        fmt::format("{}: has {} bytes; at most {} are read", file.string(), *size, kMostBytes)};
  std::string text(static_cast<std::size_t>(*size), '\0');
  if (!input.read(std::span(reinterpret_cast<std::uint8_t*>(text.data()), text.size())))
    return Error{file.string() + ": cannot be read to its end; check the disk"};
  return text;
}

}  // namespace aspect
