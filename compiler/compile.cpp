#include "compiler/compile.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include "compiler/aspects/clusters.h"
#include "compiler/aspects/symmetry.h"
#include "compiler/index/class_model.h"
#include "compiler/index/contour_types.h"
#include "compiler/index/index_writer.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3U;
  return hash;
}

CompileStatistics statistics_of(const Scene& scene, const CompileOptions& options,
                                const Subdivision& subdivision,
                                const std::vector<Cluster>& clusters) {
  CompileStatistics s;
  s.object = scene.name;
  s.level = options.level;
  s.threshold = options.threshold;
  s.cluster_threshold = options.cluster_threshold;
  s.triangles = subdivision.sphere.leaves().size();
  s.views = subdivision.views.size();
  s.views_rendered = subdivision.views_rendered;
  s.match_calls = subdivision.match_calls;
  s.matches_executed = subdivision.matches_executed;
  s.matches_gave_up = subdivision.matches_gave_up;
  s.clusters = clusters.size();
  for (const Cluster& cluster : clusters) s.area_fraction += cluster.area_fraction;
  s.seconds.render = seconds(subdivision.render_time);
  s.seconds.features = seconds(subdivision.feature_time);
  s.seconds.match = seconds(subdivision.match_time);
  return s;
}

}  // namespace

Result<CompiledIndex> compile(const Scene& scene, const CompileOptions& options,
                              const std::optional<std::filesystem::path>& store_path,
                              const ShowProgress& show_progress, const std::atomic<bool>* stop) {
  const auto start = Clock::now();
  const int threads = options.jobs > 0 ? options.jobs : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const std::uint64_t scene_hash = hash_of(scene.source);
  Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return Error{scene.name + ": " + renderer.error()};
  std::optional<Store> store;
  if (store_path) {
    Result<Store> opened =
        Store::open(*store_path, {fmt::format("{:016x}", scene_hash), options.store_key()});
    if (!opened) return Error{opened.error()};
    store = std::move(opened).value();
  }

  const Workshop workshop{renderer.value(),          scene.studio,  options,
                          store ? &*store : nullptr, show_progress, stop};
  Result<Subdivision> subdivided = subdivide(workshop);
  if (!subdivided) return Error{subdivided.error()};
  const Subdivision& subdivision = subdivided.value();

  const auto subdivided_at = Clock::now();
  const std::vector<Cluster> clusters = find_clusters(subdivision, options);
  if (clusters.empty())
    return Error{fmt::format(
        "{}: no patch of the viewing sphere is uniform at level {}; raise --level or --threshold",
        scene.name, options.level)};

  const auto clustered_at = Clock::now();
  const Symmetries symmetries = find_symmetries(workshop, subdivision);

  const auto symmetries_at = Clock::now();
  const std::vector<TypeAttributes> types = find_contour_types(
      contour_samples(subdivision, clusters), static_cast<std::size_t>(options.contour_types));
  std::vector<ClassDescription> classes;
  for (const Cluster& cluster : clusters)
    classes.push_back(describe_class(subdivision, cluster, types, options.scoring));

  const auto typed_at = Clock::now();
  WrittenIndex index =
      write_index({scene, scene_hash, options, subdivision, clusters, classes, types, symmetries});

  CompileStatistics s = statistics_of(scene, options, subdivision, clusters);
  s.clusters_in_index = index.class_count;
  s.key_views = index.key_view_count;
  s.key_view_spacing_deg = index.key_view_spacing_deg;
  s.contour_types = types.size();
  s.area_fraction_in_index = index.area_fraction;
  s.index_bytes = index.bytes.size();
  s.threads = threads;
  s.seconds.cluster = seconds(clustered_at - subdivided_at);
  s.symmetries = symmetries.rotations.size();
  s.symmetry_axes = symmetries.axes.size();
  s.symmetry_views = symmetries.views_rendered;
  s.seconds.symmetry = seconds(symmetries_at - clustered_at);
  s.seconds.types = seconds(typed_at - symmetries_at);
  s.seconds.emit = seconds(Clock::now() - typed_at);
  s.seconds.total = seconds(Clock::now() - start);
  return CompiledIndex{std::move(index.bytes), s};
}

}  // namespace aspect
