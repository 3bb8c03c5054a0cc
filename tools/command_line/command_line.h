// How every program takes its command line.
#pragma once

#include <optional>

namespace CLI {
class App;
}

namespace aspect {

inline constexpr int kUsageError = 2;

// Nothing where the program goes on. Otherwise the exit code: 0 where help or the version was asked
// for and is printed, kUsageError after one line on stderr.
std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv);

}  // namespace aspect
