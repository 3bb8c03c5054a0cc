// How every program takes its command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace aspect {

inline constexpr int kUsageError = 2;

// Nothing where the program goes on. Otherwise the exit code: 0 where help or the version was asked
// for and is printed, or the documents are written (--help-documents FOLDER, which the build uses);
// kUsageError after one line on stderr.
std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv);

// One of these words and no other: checked, in --help, and completed.
CLI::Option* take_words(CLI::Option* option, const std::vector<std::string>& words);

}  // namespace aspect
