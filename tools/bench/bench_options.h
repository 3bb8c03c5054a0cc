// The command line of aspect-bench: Google Benchmark's, with help, manual and completions as every
// program has them.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace aspect {

struct BenchOptions {
  std::vector<std::string> words;  // for benchmark::Initialize, after the program's name
  std::filesystem::path plot;      // empty: none
  std::filesystem::path from;      // results to draw in place of measuring; empty: none
};

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<BenchOptions, int> parse_bench_options(int argc, const char* const* argv);

}  // namespace aspect
