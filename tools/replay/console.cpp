#include "tools/replay/console.h"

#include <fmt/format.h>
#include <unistd.h>
#include <cstdio>

#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

std::string on_one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  return line;
}

// The end of a name says more than its beginning.
std::string_view tail(std::string_view text) {
  constexpr std::size_t kMost = 56;
  return text.size() > kMost ? text.substr(text.size() - kMost) : text;
}

}  // namespace

Console::Console(std::string program)
    : program_(std::move(program)),
      shows_progress_(isatty(STDERR_FILENO) == 1 && isatty(STDOUT_FILENO) == 0) {}

Console::~Console() {
  clear_progress();
}

void Console::fail(std::string_view message) {
  ++failures_;
  clear_progress();
  print_failure(program_, on_one_line(message));
}

void Console::warn(std::string_view message) {
  clear_progress();
  print_warning(program_, on_one_line(message));
}

void Console::tell(std::string_view message) {
  clear_progress();
  fmt::print(stderr, "{}: {}\n", program_, on_one_line(message));
}

void Console::progress(std::uint64_t done, std::optional<std::size_t> all, std::string_view name) {
  if (!shows_progress_) return;
  clear_progress();
  const std::string of = all ? fmt::format("/{}", *all) : "";
  fmt::print(stderr, "{}{} {}", done, of, on_one_line(tail(name)));
  std::fflush(stderr);
  progress_shown_ = true;
}

void Console::clear_progress() {
  // Back to the line's beginning and erase to its end (ECMA-48, EL).
  if (progress_shown_) fmt::print(stderr, "\r\x1b[K");
  progress_shown_ = false;
}

}  // namespace aspect
