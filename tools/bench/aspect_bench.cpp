// aspect-bench: how long the stages take.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tools/bench/bench_options.h"

namespace aspect {
namespace {

int run_benchmarks(char* program, std::vector<std::string> options) {
  // It knows terminals, and nothing of this.
  if (const char* no_colour = std::getenv("NO_COLOR"); no_colour != nullptr && *no_colour != '\0')
    options.insert(options.begin(), "--benchmark_color=false");
  std::vector<char*> words{program};
  for (std::string& option : options) words.push_back(option.data());
  int count = static_cast<int>(words.size());
  words.push_back(nullptr);
  benchmark::Initialize(&count, words.data());
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  try {
    auto options = aspect::parse_bench_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return aspect::run_benchmarks(argv[0], std::get<std::vector<std::string>>(std::move(options)));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aspect-bench: %s\n", error.what());
    return 1;
  }
}
