// Lines whose every byte is known from their number, so that a reader can tell whether it has all
// of one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace aspect {

// Of 20 to `longest` bytes with the end: the number, then letters that depend on it.
std::string made_line(std::uint64_t number, std::size_t longest);
// Its number, or none if a byte is wrong or missing.
std::optional<std::uint64_t> number_of(std::string_view line, std::size_t longest);

struct LineTally {
  std::uint64_t whole = 0, broken = 0, gaps = 0, disordered = 0;
  std::string rest;  // after the last line break
  std::optional<std::uint64_t> last;

  // Takes what was read; may end in the middle of a line.
  void take(std::string_view bytes, std::size_t longest);
};

}  // namespace aspect
