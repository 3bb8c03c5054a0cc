// What a frame costs on one core, stage by stage, beside a baseline of the same run: reading every
// byte of the frame once. Inputs are in tests/data/rendered.
//
// usage: aspect-bench [--benchmark_filter=...]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "compiler/aspects/observer.h"
#include "compiler/compile.h"
#include "compiler/render/renderer.h"
#include "compiler/scene/bob_reader.h"
#include "runtime/base/planned_memory.h"
#include "runtime/recognition/recogniser.h"
#include "tools/bench/bench_inputs.h"

namespace aspect {
namespace {

constexpr int kIndexLevel = 5;

std::vector<cv::Mat> load_frames() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(rendered_folder() / "frames"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<cv::Mat> frames;
  for (const auto& file : files) frames.push_back(cv::imread(file.string()));
  return frames;
}

Frame frame_of(const cv::Mat& picture) {
  return {picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step[0]),
          PixelFormat::bgr8};
}

void read_every_byte(benchmark::State& state) {
  const std::vector<cv::Mat> frames = load_frames();
  std::size_t next = 0;
  for (auto _ : state) {
    const cv::Mat& frame = frames[next++ % frames.size()];
    benchmark::DoNotOptimize(std::accumulate(frame.datastart, frame.dataend, std::uint64_t{0}));
  }
}
BENCHMARK(read_every_byte)->Unit(benchmark::kMillisecond);

void frame_to_graph(benchmark::State& state) {
  const std::vector<cv::Mat> frames = load_frames();
  Vision vision;
  PlannedMemory memory;
  memory.plan([&](Arena& arena) { vision.prepare(arena, 512, 512); });
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        vision.run(frame_of(frames[next++ % frames.size()]), {}).contours.size());
}
BENCHMARK(frame_to_graph)->Unit(benchmark::kMillisecond);

const std::vector<ClassIndex>& five_indexes() {
  static const std::vector<ClassIndex> indexes = [] {
    std::vector<ClassIndex> made;
    for (const char* name : {"cube", "l_shape", "blockcyl1", "blockcyl2", "pegblock"}) {
      const Scene scene = checked(read_bob(rendered_folder() / (std::string(name) + ".b")));
      CompileOptions options;
      options.level = kIndexLevel;
      const CompiledIndex index = checked(compile(scene, options, std::nullopt, {}, nullptr));
      made.push_back(checked(parse_index(std::as_bytes(std::span(index.bytes)), name)));
    }
    return made;
  }();
  return indexes;
}

void recognise_with_five_indexes(benchmark::State& state) {
  const std::vector<ClassIndex>& indexes = five_indexes();
  const std::vector<cv::Mat> frames = load_frames();
  Recogniser recogniser;
  PlannedMemory memory;
  memory.plan([&](Arena& arena) { recogniser.prepare(arena, indexes, {}, 512, 512); });
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        recogniser.recognise(frame_of(frames[next++ % frames.size()])).objects.size());
}
BENCHMARK(recognise_with_five_indexes)->Unit(benchmark::kMillisecond);

void render_cube(benchmark::State& state) {
  const Scene scene = checked(read_bob(rendered_folder() / "cube.b"));
  const Renderer renderer = checked(Renderer::create(scene));
  const std::vector<Eigen::Vector3d> views = directions();
  Picture picture;
  std::size_t next = 0;
  for (auto _ : state)
    renderer.render(camera_at(scene.studio, views[next++ % views.size()]), picture);
}
BENCHMARK(render_cube)->Unit(benchmark::kMillisecond);

void view_of_cube_to_graph(benchmark::State& state) {
  const Scene scene = checked(read_bob(rendered_folder() / "cube.b"));
  const Renderer renderer = checked(Renderer::create(scene));
  Observer observer(renderer, scene.studio, {});
  const std::vector<Eigen::Vector3d> views = directions();
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(observer.observe(views[next++ % views.size()]).contours.size());
}
BENCHMARK(view_of_cube_to_graph)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace aspect
