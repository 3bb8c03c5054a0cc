#include "tools/command_line/terminal_colour.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace aspect {
namespace {

// Select Graphic Rendition (ECMA-48): bold green, yellow and red, in the order of Tone.
constexpr std::array<std::string_view, 3> kTones = {"\x1b[1;32m", "\x1b[1;33m", "\x1b[1;31m"};
constexpr std::string_view kPlain = "\x1b[0m";

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

}  // namespace

bool shows_colours(std::FILE* stream) {
  return isatty(fileno(stream)) == 1 && variable("NO_COLOR").empty() &&
         variable("TERM") != "dumb" && !variable("TERM").empty();
}

std::string toned(std::string_view text, Tone tone, bool colours) {
  if (!colours) return std::string(text);
  return fmt::format("{}{}{}", kTones[static_cast<std::size_t>(tone)], text, kPlain);
}

void print_failure(std::string_view program, std::string_view message) {
  const bool colours = shows_colours(stderr);
  fmt::print(stderr, "{} {}\n", toned(fmt::format("{}:", program), Tone::bad, colours), message);
}

void print_warning(std::string_view program, std::string_view message) {
  const bool colours = shows_colours(stderr);
  fmt::print(stderr, "{}: {} {}\n", program, toned("warning:", Tone::doubtful, colours), message);
}

}  // namespace aspect
