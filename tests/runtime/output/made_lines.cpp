#include "tests/runtime/output/made_lines.h"

namespace aspect {

std::string made_line(std::uint64_t number, std::size_t longest) {
  std::string line = std::to_string(number) + " ";
  const auto length = static_cast<std::size_t>(20 + (number * 2654435761U >> 7U) % (longest - 19));
  for (std::uint64_t k = number; line.size() + 1 < length; ++k)
    line.push_back(static_cast<char>('a' + (k * k + number) % 26));
  return line + "\n";
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
