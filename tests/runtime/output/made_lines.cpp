#include "tests/runtime/output/made_lines.h"

#include <algorithm>

namespace aspect {

std::string made_line(std::uint64_t number, std::size_t longest) {
  std::string line = std::to_string(number) + " ";
  const auto length = static_cast<std::size_t>(20 + (number * 2654435761U >> 7U) % (longest - 19));
  // Letter k*k + number for k from number on. Most of the time of tests goes here: no divisions.
  auto letter = static_cast<unsigned>((number * number + number) % 26);
  auto step = static_cast<unsigned>((2 * number + 1) % 26);
  std::size_t at = line.size();
  line.resize(std::max(length, at + 1), '\n');
  for (; at + 1 < length; ++at) {
    line[at] = static_cast<char>('a' + letter);
    letter = letter + step < 26 ? letter + step : letter + step - 26;
    step = step < 24 ? step + 2 : step - 24;
  }
  return line;
}

std::optional<std::uint64_t> number_of(std::string_view line, std::size_t longest) {
  std::uint64_t number = 0;
  for (const char digit : line.substr(0, line.find(' '))) {
    if (digit < '0' || digit > '9') return std::nullopt;
    number = number * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  if (made_line(number, longest) != line) return std::nullopt;
  return number;
}

void LineTally::take(std::string_view bytes, std::size_t longest) {
  rest += bytes;
  std::size_t begin = 0;
  for (std::size_t end; (end = rest.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const auto number = number_of(std::string_view(rest).substr(begin, end + 1 - begin), longest);
    if (!number) {
      ++broken;
      continue;
    }
    ++whole;
    if (last && *number <= *last) ++disordered;
    if (last && *number > *last + 1) ++gaps;
    last = number;
  }
  rest.erase(0, begin);
}

}  // namespace aspect
