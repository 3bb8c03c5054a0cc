// The command line of aspect-bench: Google Benchmark's, with help, manual and completions as every
// program has them.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace aspect {

// Words for benchmark::Initialize after the program's name, or the exit code after help, version or
// a complaint have been printed.
std::variant<std::vector<std::string>, int> parse_bench_options(int argc, const char* const* argv);

}  // namespace aspect
