// How every program takes its command line.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

namespace aspect {

inline constexpr int kUsageError = 2;

// Nothing where the program goes on. Otherwise the exit code: 0 where help or the version was asked
// for and is printed, kUsageError after one line on stderr.
inline std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    fmt::print(stderr, "{0}: {1}; see {0} --help\n", app.get_name(), error.what());
    return kUsageError;
  }
}

}  // namespace aspect
