#include "compiler/compile.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <utility>

#include "compiler/aspects/border_classes.h"
#include "compiler/aspects/symmetry.h"
#include "compiler/index/calibration.h"
#include "compiler/index/class_model.h"
#include "compiler/index/golden_choice.h"
#include "compiler/index/index_bytes.h"
#include "compiler/recipe.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

// Tells how long each stage took.
class StageClock {
 public:
  double stage_s() {
    const auto before = std::exchange(stage_start_, Clock::now());
    return seconds(stage_start_ - before);
  }
  double total_s() const { return seconds(Clock::now() - start_); }

 private:
  Clock::time_point start_ = Clock::now(), stage_start_ = start_;
};

// Views and matches, by way of the store, which is complete and closed on return.
Result<Subdivision> subdivided(const Scene& scene,
                               const std::optional<std::filesystem::path>& store_path,
                               Workshop workshop) {
  if (!store_path) return subdivide(workshop);
  const CompileOptions& options = workshop.options;
  Result<Store> store = Store::open(*store_path, store_key_of(scene, options));
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

// How far the written index can be trusted.
std::optional<Calibration> calibration_of(const Workshop& workshop, const Scene& scene,
                                          const std::vector<std::uint8_t>& bytes) {
  const Result<ClassIndex> index = parse_index(std::as_bytes(std::span(bytes)), scene.name);
  return index ? calibrated(workshop, scene, index.value()) : std::nullopt;
}

}  // namespace

Result<LearntModel> compile_model(const Scene& scene, const CompileOptions& options,
                                  const std::optional<std::filesystem::path>& store_path,
                                  const ShowProgress& show_progress,
                                  const std::atomic<bool>* stop) {
  StageClock clock;
  const int threads = options.jobs > 0 ? options.jobs : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  CompileStatistics statistics{scene.name,        options.vision.sensor,     options.level,
                               options.threshold, options.cluster_threshold, threads};
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
  Result<Subdivision> subdivided_sphere = subdivided(scene, store_path, workshop);
  if (!subdivided_sphere) return Error{subdivided_sphere.error()};
  Subdivision& subdivision = subdivided_sphere.value();
  statistics.subdivision = subdivision.statistics;
  clock.stage_s();

  std::vector<Cluster> clusters = find_clusters(subdivision, options);
  if (clusters.empty())
    return Error{fmt::format(
        "{}: no patch of the viewing sphere is uniform at level {}; raise --level or --threshold",
        scene.name, options.level)};
  SphereClasses sphere_classes = divide_borders(subdivision, options, clusters);
  if (stopped()) return interrupted;
  statistics.clusters = statistics_of(clusters);
  statistics.seconds.cluster = clock.stage_s();
  progress.clusters = clusters.size();
  show(progress);

  Symmetries symmetries = find_symmetries(workshop, subdivision);
  statistics.symmetries = symmetries.rotations.size();
  statistics.symmetry_axes = symmetries.axes.size();
  statistics.symmetry_views = symmetries.views_rendered;
  statistics.seconds.symmetry = clock.stage_s();

  auto [types, classes] = describe_classes(subdivision, clusters, options);
  if (stopped()) return interrupted;
  statistics.seconds.types = clock.stage_s();

  const std::vector<GoldenFrame> golden =
      golden_candidates(workshop, subdivision, clusters, classes);
  WrittenIndex index =
      write_index({scene, scene_hash_of(scene), options, subdivision, clusters, sphere_classes,
                   classes, types, symmetries, golden, packed_model(scene)});
  statistics.index = index.statistics;
  if (const auto calibration = calibration_of(workshop, scene, index.bytes))
    set_calibration(index.bytes, *calibration);
  if (stopped()) return interrupted;
  statistics.seconds.emit = clock.stage_s();
  statistics.seconds.total = clock.total_s();
  return LearntModel{std::move(subdivision),
                     std::move(clusters),
                     std::move(sphere_classes),
                     std::move(symmetries),
                     std::move(types),
                     std::move(classes),
                     {std::move(index.bytes), statistics}};
}

Result<CompiledIndex> compile(const Scene& scene, const CompileOptions& options,
                              const std::optional<std::filesystem::path>& store_path,
                              const ShowProgress& show_progress, const std::atomic<bool>* stop) {
  Result<LearntModel> model = compile_model(scene, options, store_path, show_progress, stop);
  if (!model) return Error{model.error()};
  return std::move(model.value().index);
}

}  // namespace aspect
