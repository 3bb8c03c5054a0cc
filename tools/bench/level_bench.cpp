// What a whole index costs by the level of its viewing sphere: every level has about four times the
// views of the one before.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "tools/bench/bench_inputs.h"

namespace aspect {
namespace {

void compile_to_level(benchmark::State& state, const std::string& name) {
  const Scene scene = checked(read_bob(model_file(name)));
  CompileOptions options;
  options.level = static_cast<int>(state.range(0));
  options.min_level = std::min(options.min_level, options.level);
  double views = 0, classes = 0;
  for (auto _ : state) {
    const CompiledIndex index = checked(compile(scene, options, std::nullopt, {}, nullptr));
    views = static_cast<double>(index.statistics.subdivision.views);
    classes = static_cast<double>(index.statistics.clusters.clusters);
  }
  state.counters["views"] = views;
  state.counters["classes"] = classes;
}

// Threads are many: the time of all of them.
BENCHMARK_CAPTURE(compile_to_level, cube, std::string("cube"))
    ->ArgName("level")
    ->DenseRange(1, 4)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compile_to_level, blockcyl2, std::string("blockcyl2"))
    ->ArgName("level")
    ->DenseRange(1, 4)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compile_to_level, truck, std::string("truck"))
    ->ArgName("level")
    ->DenseRange(2, 3)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace aspect
