#include "compiler/compile.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include "compiler/aspects/border_classes.h"
#include "compiler/aspects/clusters.h"
#include "compiler/aspects/symmetry.h"
#include "compiler/index/class_model.h"
#include "compiler/index/contour_types.h"
#include "compiler/index/golden_choice.h"
#include "compiler/index/index_writer.h"
#include "compiler/recipe.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

CompileStatistics statistics_of(const Scene& scene, const CompileOptions& options,
                                const Subdivision& subdivision,
                                const std::vector<Cluster>& clusters) {
  CompileStatistics s;
  s.object = scene.name;
  s.sensor = options.vision.sensor;
  s.level = options.level;
  s.threshold = options.threshold;
  s.cluster_threshold = options.cluster_threshold;
  s.triangles = subdivision.sphere.leaves().size();
  s.views = subdivision.sphere.vertex_count();
  s.border_views = subdivision.views.size() - s.views;
  s.views_rendered = subdivision.views_rendered;
  s.match_calls = subdivision.match_calls;
  s.matches_executed = subdivision.matches_executed;
  s.matches_gave_up = subdivision.matches_gave_up;
  s.clusters = clusters.size();
  for (const Cluster& cluster : clusters) {
    s.area_fraction += cluster.area_fraction;
    s.area_assigned += cluster.area_assigned;
  }
  s.seconds.render = seconds(subdivision.render_time);
  s.seconds.features = seconds(subdivision.feature_time);
  s.seconds.match = seconds(subdivision.match_time);
  return s;
}

// Views and matches, by way of the store, which is complete and closed on return.
Result<Subdivision> subdivided(const Scene& scene, std::uint64_t scene_hash,
                               const std::optional<std::filesystem::path>& store_path,
                               Workshop workshop) {
  if (!store_path) return subdivide(workshop);
  const CompileOptions& options = workshop.options;
  Result<Store> store = Store::open(*store_path, {fmt::format("{:016x}", scene_hash),
                                                  options.store_key(), ASPECT_VERSION, scene.name});
  if (!store) return Error{store.error()};
  workshop.store = &store.value();
  Result<Subdivision> subdivision = subdivide(workshop);
  if (!subdivision) return subdivision;
  if (Result<Done> noted = keep_recipe(store.value(), scene, options); !noted)
    return Error{noted.error()};
  const Result<Done> kept =
      store.value().add_finished_run({options.level, options.min_level, options.threshold,
                                      subdivision.value().sphere.vertex_count()});
  if (!kept) return Error{kept.error()};
  return subdivision;
}

}  // namespace

Result<CompiledIndex> compile(const Scene& scene, const CompileOptions& options,
                              const std::optional<std::filesystem::path>& store_path,
                              const ShowProgress& show_progress, const std::atomic<bool>* stop) {
  const auto start = Clock::now();
  const int threads = options.jobs > 0 ? options.jobs : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const std::uint64_t scene_hash = scene_hash_of(scene);
  Progress progress;
  const ShowProgress show = [&](const Progress& now) {
    progress = now;
    if (show_progress) show_progress(now);
  };
  const auto stopped = [stop] { return stop != nullptr && stop->load(); };
  const Error interrupted = interruption(store_path.has_value());

  const Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return Error{scene.name + ": " + renderer.error()};
  const Workshop workshop{renderer.value(), scene.studio, options, nullptr, show, stop};
  const Result<Subdivision> subdivided_sphere = subdivided(scene, scene_hash, store_path, workshop);
  if (!subdivided_sphere) return Error{subdivided_sphere.error()};
  const Subdivision& subdivision = subdivided_sphere.value();

  const auto subdivided_at = Clock::now();
  std::vector<Cluster> clusters = find_clusters(subdivision, options);
  if (clusters.empty())
    return Error{fmt::format(
        "{}: no patch of the viewing sphere is uniform at level {}; raise --level or --threshold",
        scene.name, options.level)};

  const SphereClasses sphere_classes = divide_borders(subdivision, options, clusters);

  if (stopped()) return interrupted;
  progress.clusters = clusters.size();
  show(progress);

  const auto clustered_at = Clock::now();
  const Symmetries symmetries = find_symmetries(workshop, subdivision);

  const auto symmetries_at = Clock::now();
  const std::vector<TypeAttributes> types = find_contour_types(
      contour_samples(subdivision, clusters), static_cast<std::size_t>(options.contour_types));
  std::vector<ClassDescription> classes;
  for (const Cluster& cluster : clusters)
    classes.push_back(describe_class(subdivision, cluster, types, options.scoring));

  if (stopped()) return interrupted;

  const auto typed_at = Clock::now();
  const std::vector<GoldenFrame> golden =
      golden_candidates(workshop, subdivision, clusters, classes);
  WrittenIndex index = write_index({scene, scene_hash, options, subdivision, clusters,
                                    sphere_classes, classes, types, symmetries, golden});

  CompileStatistics s = statistics_of(scene, options, subdivision, clusters);
  s.clusters_in_index = index.class_count;
  s.key_views = index.key_view_count;
  s.key_view_spacing_deg = index.key_view_spacing_deg;
  s.contour_types = types.size();
  s.area_fraction_in_index = index.area_fraction;
  s.area_assigned_in_index = index.area_assigned;
  s.index_bytes = index.bytes.size();
  s.golden_frame_bytes = index.golden_frame_bytes;
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
