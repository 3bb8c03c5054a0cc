// aspect-bench: how long the stages take.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>

#include "tools/aspectc/commands/whole_file.h"
#include "tools/bench/bench_options.h"
#include "tools/bench/bench_results.h"
#include "tools/bench/bench_svg.h"
#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

int fail(const std::string& message) {
  print_failure("aspect-bench", message);
  return 1;
}

BenchResults measured(char* program, std::vector<std::string> options) {
  // It knows terminals, and nothing of this.
  if (const char* no_colour = std::getenv("NO_COLOR"); no_colour != nullptr && *no_colour != '\0')
    options.insert(options.begin(), "--benchmark_color=false");
  std::vector<char*> words{program};
  for (std::string& option : options) words.push_back(option.data());
  int count = static_cast<int>(words.size());
  words.push_back(nullptr);
  benchmark::Initialize(&count, words.data());
  BenchResults results;
  const std::unique_ptr<benchmark::BenchmarkReporter> shown(
      benchmark::CreateDefaultDisplayReporter());
  GatheringReporter reporter(*shown, results);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return results;
}

int run(char* program, const BenchOptions& options) {
  if (!options.plot.empty())
    if (const auto done = check_writable(options.plot); !done) return fail(done.error());
  const Result<BenchResults> results =
      options.from.empty() ? measured(program, options.words) : read_bench_results(options.from);
  if (!results) return fail(results.error());
  if (options.plot.empty()) return 0;
  const Result<std::string> svg = bench_svg(results.value().medians());
  if (!svg) return fail(options.plot.native() + ": " + svg.error());
  const auto done = write_whole_text(options.plot, svg.value());
  return done ? 0 : fail(done.error());
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  try {
    auto options = aspect::parse_bench_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::run(argv[0], std::get<aspect::BenchOptions>(options));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aspect-bench: %s\n", error.what());
    return 1;
  }
}
