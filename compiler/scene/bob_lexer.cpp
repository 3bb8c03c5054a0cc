#include "compiler/scene/bob_lexer.h"

namespace aspect {
namespace {

// The C locale's classes, whatever the program's locale is.
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_sign(char c) {
  return c == '+' || c == '-';
}
bool is_exponent(char c) {
  return c == 'e' || c == 'E';
}

}  // namespace

// Blanks between the backslash and the end of the line are an invisible mistake: accepted.
bool BobLexer::skip_continuation() {
  if (at(0) != '\\') return false;
  std::size_t end = 1;
  while (is_blank(at(end))) ++end;
  if (at(end) != '\n') return false;
  position_ += end + 1;
  ++line_;
  return true;
}

bool BobLexer::skip_comment() {
  if (at(0) != '/') return false;
  if (at(1) == '/') {
    while (!done() && at(0) != '\n') ++position_;
    // A comment at the end of a continued line ends there, but the line goes on.
    std::size_t last = position_ - 1;
    while (is_blank(text_[last])) --last;
    if (!done() && text_[last] == '\\') {
      ++position_;
      ++line_;
    }
    return true;
  }
  if (at(1) != '*') return false;
  const std::uint32_t opened = line_;
  for (position_ += 2; !done(); ++position_) {
    if (at(0) == '\n') ++line_;
    if (at(0) == '*' && at(1) == '/') {
      position_ += 2;
      return true;
    }
  }
  open_comment_line_ = opened;
  return true;
}

void BobLexer::skip_space() {
  while (!done()) {
    if (is_blank(at(0))) {
      ++position_;
    } else if (!skip_continuation() && !skip_comment()) {
      return;
    }
  }
}

bool BobLexer::space_follows() const {
  const char c = at(0);
  return done() || is_blank(c) || c == '\n' || c == '\\' ||
         (c == '/' && (at(1) == '/' || at(1) == '*'));
}

std::size_t BobLexer::word_length() const {
  const char first = at(0);
  std::size_t length = 1;
  if (is_letter(first)) {
    while (is_letter(at(length)) || is_digit(at(length))) ++length;
    return length;
  }
  if (first == '"') {
    while (position_ + length < text_.size() && at(length) != '\n')
      if (at(length++) == '"') return length;
    return 1;
  }
  if (!is_digit(first) && first != '.') return 1;
  // As in C, letters stick to a number, so that 1.5cm is one wrong word and not two.
  while (is_letter(at(length)) || is_digit(at(length)) || at(length) == '.' ||
         (is_sign(at(length)) && is_exponent(at(length - 1)))) {
    ++length;
  }
  return length;
}

RawWord BobLexer::next() {
  const std::size_t before = position_;
  const bool line_start = starts_line_;
  skip_space();
  RawWord word;
  word.line = line_;
  word.space_before = line_start || position_ != before;
  word.starts_line = line_start;
  if (done()) return word;
  if (at(0) == '\n') {
    word.kind = RawWord::Kind::kEndOfLine;
    ++position_;
    ++line_;
    starts_line_ = true;
    return word;
  }
  word.kind = is_letter(at(0))                  ? RawWord::Kind::kName
              : is_digit(at(0)) || at(0) == '.' ? RawWord::Kind::kNumber
                                                : RawWord::Kind::kSymbol;
  word.text = text_.substr(position_, word_length());
  if (word.text.size() > 1 && word.text.front() == '"') word.kind = RawWord::Kind::kQuoted;
  position_ += word.text.size();
  word.space_after = space_follows();
  starts_line_ = false;
  return word;
}

std::optional<std::string_view> BobLexer::file_name() {
  skip_space();
  const bool quoted = at(0) == '"';
  if (quoted) ++position_;
  const std::size_t begin = position_;
  while (!done() && at(0) != '\n' && (quoted ? at(0) != '"' : !is_blank(at(0)))) ++position_;
  const std::string_view name = text_.substr(begin, position_ - begin);
  if (!quoted) return name;
  if (at(0) != '"') return std::nullopt;
  ++position_;
  return name;
}

}  // namespace aspect
