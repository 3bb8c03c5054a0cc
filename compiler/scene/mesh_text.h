// The words of a mesh file that is text, with their lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// Views the text. Throws MeshError with the line.
class MeshText {
 public:
  explicit MeshText(std::string_view text) : text_(text) {}

  bool at_end() const { return position_ >= text_.size(); }
  std::size_t line() const { return line_; }
  std::size_t position() const { return position_; }  // of the next line, in bytes

  // The next line without its end; empty at the end.
  std::string_view take_line();
  // The words of the next line that has any, without what follows a '#'; fails at the end.
  std::vector<std::string_view> take_words(std::string_view what);

  double number(std::string_view word) const;
  // A whole number from 0 to `most`.
  std::size_t count(std::string_view word, std::size_t most) const;
  [[noreturn]] void fail(const std::string& message) const { throw MeshError(message, line_); }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
};

std::vector<std::string_view> words_of(std::string_view line);

// What follows a word of the line, which it views, without white space and quotes around it.
std::string_view rest_of_line(std::string_view line, std::string_view word);

std::string lower_case(std::string_view word);

// The text itself, or where carriage returns alone end its lines the same with line feeds, in
// `held`.
std::string_view with_line_feeds(std::string_view text, std::string& held);

// UTF-8's, which some editors write in front.
std::string_view without_byte_order_mark(std::string_view text);

// A word as it may stand in a message: cut short, nothing but printable ASCII.
std::string shown(std::string_view word);

}  // namespace aspect
