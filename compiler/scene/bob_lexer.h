// Cuts the text of one file into words: no comments, continued lines joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace aspect {

// A piece of text between white space: a name, a number without its sign, a text with its quotes,
// or one other character (a quote that is not closed on its line, too).
struct RawWord {
  enum class Kind { kName, kNumber, kQuoted, kSymbol, kEndOfLine, kEndOfText };

  Kind kind = Kind::kEndOfText;
  std::string_view text;
  std::uint32_t line = 0;
  bool space_before = false;
  bool space_after = false;
  bool starts_line = false;  // first of a line, continuations counted as the same line
};

class BobLexer {
 public:
  explicit BobLexer(std::string_view text) : text_(text) {}

  // At the end of the text, kEndOfText for ever.
  RawWord next();

  // The name in `#include name` or `#include "name"`; empty where there is none, nothing where a
  // quote is not closed on its line.
  std::optional<std::string_view> file_name();

  std::uint32_t line() const { return line_; }

  // The line of a `/*` that the text never closes; 0 where all is well. Its end is the text's end.
  std::uint32_t open_comment_line() const { return open_comment_line_; }

 private:
  char at(std::size_t offset) const {
    return position_ + offset < text_.size() ? text_[position_ + offset] : '\0';
  }
  bool done() const { return position_ >= text_.size(); }
  void skip_space();
  bool skip_continuation();
  bool skip_comment();
  bool space_follows() const;
  std::size_t word_length() const;

  std::string_view text_;
  std::size_t position_ = 0;
  std::uint32_t line_ = 1;
  std::uint32_t open_comment_line_ = 0;
  bool starts_line_ = true;
};

}  // namespace aspect
