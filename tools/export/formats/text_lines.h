// Reading of the thesis's text files (appendix A.2): line by line, word by word, and a line of
// error that names file and line where they are not what they should be.
//
// Blank lines and blanks at a line's ends mean nothing. A line that ends with a backslash goes on
// in the next one, as the appendix prints long ones; the writers never break a line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include "runtime/base/result.h"

namespace aspect {

// What a reader of a file throws on the way, and parsed_text makes an Error of.
struct MalformedText {
  std::string message;
};

// What counts and ids may be at most: more than any model has, and less than overflows a sum.
inline constexpr std::int64_t kMostId = 1'000'000'000;
// Attributes may be this large, either way.
inline constexpr std::int64_t kMostAttribute = 1'000'000'000'000'000;

class TextLines {
 public:
  // Text and name must outlive it. `remedy` ends every complaint: the form of the lines.
  TextLines(std::string_view text, std::string_view name, std::string_view remedy);

  // Goes to the next line that is not blank; false where there is none.
  bool next();
  // The same where a line must follow.
  void need_next(std::string_view what);
  // Nothing may be left of the line.
  void end_line();
  bool at_line_end();

  // Each skips blanks first. A word ends at a blank.
  std::string_view word(std::string_view what);
  std::int64_t whole_word(std::string_view what, std::int64_t least, std::int64_t most);
  double real_word(std::string_view what);
  // Parts of a line that need no blanks between them.
  void expect(std::string_view literal);
  bool accept(std::string_view literal);
  std::int64_t whole(std::string_view what, std::int64_t least, std::int64_t most);
  // As many characters as are in this set, at least one.
  std::string_view run_of(std::string_view characters, std::string_view what);
  // The next character, 0 at the line's end.
  char peek();

  // "x.vert:3: what; remedy".
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const;
  std::size_t line_number() const { return first_line_; }

 private:
  std::string_view take_line();
  void skip_blanks();
  std::string_view next_word();

  std::string_view text_, name_, remedy_;
  std::string joined_;     // of lines that go on
  std::string_view line_;  // what is left of it
  std::size_t lines_taken_ = 0, first_line_ = 0;
};

// A part of a file in an error: printable and short.
std::string excerpt_of(std::string_view text);

// What read(lines) gives, or its complaint.
template <typename Read>
auto parsed_text(std::string_view text, std::string_view name, std::string_view remedy,
                 const Read& read) -> Result<decltype(read(std::declval<TextLines&>()))> {
  TextLines lines(text, name, remedy);
  try {
    return read(lines);
  } catch (const MalformedText& fault) {
    return Error{fault.message};
  }
}

// The whole of a file of at most a GiB.
Result<std::string> read_text_file(const std::filesystem::path& file);

}  // namespace aspect
