// How far the renderer is from bare Embree, in the processor's time, both by turns view by view:
// all pixels of a view, and the rays alone that the tile map leaves over.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "compiler/render/embree_scene.h"
#include "compiler/render/pixel_writer.h"
#include "compiler/render/renderer.h"
#include "compiler/render/shading.h"
#include "compiler/render/tile_tracer.h"
#include "compiler/scene/bob_reader.h"
#include "compiler/scene/mesh_reader.h"
#include "tools/bench/bare_embree.h"
#include "tools/bench/bench_inputs.h"

namespace aspect {
namespace {

// Of the work done a second time: what went before decides what the caches hold.
template <typename Work>
double warm_cpu_s_of(const Work& work) {
  work();
  const double start = cpu_s();
  work();
  return cpu_s() - start;
}

template <typename Work>
double cpu_s_of(const Work& work) {
  const double start = cpu_s();
  work();
  return cpu_s() - start;
}

std::vector<std::vector<Triangle>> triangles_of(const Scene& scene) {
  std::vector<std::vector<Triangle>> triangles(scene.primitives.size());
  for (std::size_t k = 0; k < triangles.size(); ++k)
    if (const auto* polygon = std::get_if<Polygon>(&scene.primitives[k].shape))
      triangles[k] = triangulate(polygon->vertices);
  return triangles;
}

// Those that the tile map gives to rays, or all.
std::vector<Box> tiles_of(const TileMap& map, bool all) {
  std::vector<Box> tiles;
  for (int row = 0; row < map.rows(); ++row)
    for (int column = 0; column < map.columns(); ++column)
      if (all || map.row(row)[column] == TileMap::kContested)
        tiles.push_back(
            {column * TileMap::kTile, row * TileMap::kTile, TileMap::kTile, TileMap::kTile});
  return tiles;
}

// The renderer's own rays without its tile map.
struct OwnRays {
  explicit OwnRays(const Scene& scene)
      : embree(checked(EmbreeScene::create(scene, triangles_of(scene)))),
        shading(scene),
        background(to_8_bit(scene.studio.background)) {}

  void trace(const Camera& camera, std::span<const Box> tiles, Picture& picture) const {
    PixelWriter writer(picture);
    TileTracer tracer(embree, shading, background, camera);
    for (const Box& tile : tiles) tracer.trace(tile, writer);
  }

  EmbreeScene embree;
  Shading shading;
  Rgb background;
};

// Seconds and rays of all views.
struct Sums {
  double render = 0, bare = 0;                          // all pixels
  double own_left = 0, bare_left = 0, robust_left = 0;  // the rays left over
  double tile_map = 0, rays = 0, rays_left = 0;
};

void report(const Sums& sums, benchmark::State& state) {
  const auto views = static_cast<double>(state.iterations());
  state.counters["render_us"] = 1e6 * sums.render / views;
  state.counters["tile_map_us"] = 1e6 * sums.tile_map / views;
  state.counters["bare_us"] = 1e6 * sums.bare / views;
  state.counters["pixels_pct_of_bare"] = 100 * sums.bare / sums.render;
  state.counters["rays_left_pct"] = 100 * sums.rays_left / sums.rays;
  state.counters["rays_per_us"] = 1e-6 * sums.rays_left / sums.own_left;
  state.counters["rays_pct_of_bare"] = 100 * sums.bare_left / sums.own_left;
  state.counters["rays_pct_of_robust"] = 100 * sums.robust_left / sums.own_left;
}

void compare(benchmark::State& state, const Scene& scene) {
  const Renderer renderer = checked(Renderer::create(scene));
  const OwnRays own(scene);
  const SceneOutline outline = outline_of(scene, triangles_of(scene));
  BareEmbree bare(scene, false), robust(scene, true);
  Picture picture;
  std::vector<std::uint32_t> ids;
  const std::vector<Eigen::Vector3d> views = directions();
  Sums sums;
  std::size_t next = 0;
  for (auto _ : state) {
    const Camera camera = camera_at(scene.studio, views[next++ % views.size()]);
    sums.render += cpu_s_of([&] { renderer.render(camera, picture); });
    const std::vector<Box> all = tiles_of(picture.tiles, true);
    const std::vector<Box> left = tiles_of(picture.tiles, false);
    sums.bare += cpu_s_of([&] { bare.trace(camera, all, ids); });
    sums.tile_map += cpu_s_of([&] { picture.tiles.classify(outline, camera); });
    sums.own_left += warm_cpu_s_of([&] { own.trace(camera, left, picture); });
    sums.bare_left += warm_cpu_s_of([&] { bare.trace(camera, left, ids); });
    sums.robust_left += warm_cpu_s_of([&] { robust.trace(camera, left, ids); });
    sums.rays += 16 * static_cast<double>(all.size());
    sums.rays_left += 16 * static_cast<double>(left.size());
  }
  report(sums, state);
}

void render_against_embree(benchmark::State& state, const std::string& name) {
  compare(state, checked(read_bob(model_file(name))));
}
BENCHMARK_CAPTURE(render_against_embree, cube, std::string("cube"));
BENCHMARK_CAPTURE(render_against_embree, holeblock, std::string("holeblock"));
BENCHMARK_CAPTURE(render_against_embree, blockcyl2, std::string("blockcyl2"));
BENCHMARK_CAPTURE(render_against_embree, truck, std::string("truck"));

void render_large_mesh_against_embree(benchmark::State& state) {
  const std::filesystem::path path = "build/bench/large_mesh.ply";
  if (!std::filesystem::exists(path)) {
    state.SkipWithError("run tools/bench/large_mesh.py build/bench/large_mesh.ply first");
    return;
  }
  compare(state, checked(read_mesh(path)));
}
BENCHMARK(render_large_mesh_against_embree);

}  // namespace
}  // namespace aspect
