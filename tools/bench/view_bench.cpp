// Where the time of a view goes, on one core: rendering, segmentation, features, matching with its
// neighbours, storing. Every iteration is one view of a viewing sphere of level 4, so that the
// times of the three benchmarks of an object add up.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "compiler/aspects/subdivision.h"
#include "compiler/aspects/view_codec.h"
#include "compiler/scene/bob_reader.h"
#include "tools/bench/bench_inputs.h"

namespace aspect {
namespace {

constexpr int kLevel = 4;

CompileOptions options() {
  CompileOptions options;
  options.level = kLevel;
  options.border_views = 0;
  return options;
}

// A scene's views, each with the neighbours of lower number that it is matched with.
struct Sphere {
  explicit Sphere(const std::string& name)
      : scene(checked(read_bob(model_file(name)))),
        renderer(checked(Renderer::create(scene))),
        subdivision(checked(subdivide({renderer, scene.studio, options(), nullptr, {}, nullptr}))),
        neighbours(subdivision.views.size()) {
    std::unordered_set<std::uint64_t> met;
    for (const PatchId id : subdivision.sphere.leaves()) {
      const auto& corners = subdivision.sphere.patch(id).corners;
      for (std::size_t k = 0; k < 3; ++k) add_pair(corners[k], corners[(k + 1) % 3], met);
    }
  }

  void add_pair(VertexId a, VertexId b, std::unordered_set<std::uint64_t>& met) {
    const auto low = static_cast<std::size_t>(std::min(a, b));
    const auto high = static_cast<std::size_t>(std::max(a, b));
    const std::vector<ObservedView>& views = subdivision.views;
    if (views[low].external_count == 0 || views[low].external_count != views[high].external_count)
      return;
    if (met.insert(pair_key(a, b)).second) neighbours[high].push_back(low);
  }

  Scene scene;
  Renderer renderer;
  Subdivision subdivision;
  std::vector<std::vector<std::size_t>> neighbours;  // by view
};

void observe(benchmark::State& state, const std::string& name) {
  const Sphere sphere(name);
  Observer observer(sphere.renderer, sphere.scene.studio, {});
  VisionTimes sum;
  std::size_t next = 0;
  const double start_s = cpu_s();
  for (auto _ : state) {
    const std::size_t view = next++ * 7919 % sphere.subdivision.views.size();
    benchmark::DoNotOptimize(observer.observe(sphere.subdivision.views[view].direction));
    const VisionTimes& times = observer.vision_times();
    sum.convert += times.convert;
    sum.enhance += times.enhance;
    sum.segment += times.segment;
    sum.features += times.features;
  }
  // The stages are timed by the clock on the wall: scaled, they add up to the processor's time.
  const double us = 1e6 * (cpu_s() - start_s);
  const std::chrono::duration<double> whole = observer.render_time() + observer.feature_time();
  const auto in_us = [&](std::chrono::duration<double> time) {
    return benchmark::Counter(us * (time / whole), benchmark::Counter::kAvgIterations);
  };
  const auto vision = sum.convert + sum.enhance + sum.segment + sum.features;
  state.counters["1_render_us"] = in_us(observer.render_time());
  state.counters["2_convert_us"] = in_us(sum.convert);
  state.counters["3_enhance_us"] = in_us(sum.enhance);
  state.counters["4_segment_us"] = in_us(sum.segment);
  state.counters["5_features_us"] = in_us(sum.features);
  state.counters["6_locate_us"] = in_us(observer.feature_time() - vision);
}

void match(benchmark::State& state, const std::string& name) {
  const Sphere sphere(name);
  const std::vector<ObservedView>& views = sphere.subdivision.views;
  const MatchLimits limits = options().match_limits();
  std::size_t next = 0, matches = 0;
  for (auto _ : state) {
    const std::size_t view = next++ % views.size();
    for (const std::size_t neighbour : sphere.neighbours[view])
      benchmark::DoNotOptimize(match_graphs(views[neighbour], views[view], {}, limits).cost);
    matches += sphere.neighbours[view].size();
  }
  state.counters["matches"] =
      benchmark::Counter(static_cast<double>(matches), benchmark::Counter::kAvgIterations);
}

// A store that is thrown away.
class FreshStore {
 public:
  FreshStore() { renew(); }
  ~FreshStore() {
    store_.reset();
    std::filesystem::remove(path_);
  }
  FreshStore(const FreshStore&) = delete;
  FreshStore& operator=(const FreshStore&) = delete;

  void renew() {
    store_.reset();
    std::filesystem::remove(path_);
    store_ = std::make_unique<Store>(checked(Store::open(path_, {"scene", "options"})));
  }
  Store& store() { return *store_; }

 private:
  const std::filesystem::path path_ = std::filesystem::temp_directory_path() / "aspect_bench.store";
  std::unique_ptr<Store> store_;
};

void store(benchmark::State& state, const std::string& name) {
  const Sphere sphere(name);
  const std::vector<ObservedView>& views = sphere.subdivision.views;
  FreshStore fresh;
  std::size_t view = 0;
  for (auto _ : state) {
    if (view == views.size()) {
      state.PauseTiming();
      fresh.renew();
      view = 0;
      state.ResumeTiming();
    }
    const Eigen::Vector3d& direction = views[view].direction;
    checked(fresh.store().add_view(direction, encode_view(views[view])));
    for (const std::size_t neighbour : sphere.neighbours[view]) {
      const GraphMatch* match = sphere.subdivision.matches.find(static_cast<VertexId>(neighbour),
                                                                static_cast<VertexId>(view));
      if (match != nullptr)
        checked(fresh.store().add_match(views[neighbour].direction, direction, match->cost,
                                        encode_mapping(*match)));
    }
    ++view;
  }
}

BENCHMARK_CAPTURE(observe, cube, std::string("cube"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(match, cube, std::string("cube"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(store, cube, std::string("cube"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(observe, blockcyl2, std::string("blockcyl2"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(match, blockcyl2, std::string("blockcyl2"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(store, blockcyl2, std::string("blockcyl2"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(observe, truck, std::string("truck"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(match, truck, std::string("truck"))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(store, truck, std::string("truck"))->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace aspect
