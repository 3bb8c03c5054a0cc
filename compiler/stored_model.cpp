#include "compiler/stored_model.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <utility>

namespace aspect {
namespace {

Result<Done> lower_level(const std::filesystem::path& store, int level, CompileOptions& options) {
  if (level < options.level) options.border_views = 0;
  if (level > options.level)
    return Error{fmt::format("{}: its model goes to level {}, not {}; compile the scene deeper",
                             store.string(), options.level, level)};
  options.level = level;
  options.min_level = std::min(options.min_level, level);
  return Done{};
}

// Only the store's own views and matches: it stays open no longer.
Result<Subdivision> subdivided(const std::filesystem::path& path, const Recipe& recipe,
                               Workshop workshop) {
  Result<Store> store = Store::open(path, store_key_of(recipe.scene, recipe.options));
  if (!store) return Error{store.error()};
  workshop.store = &store.value();
  return subdivide(workshop);
}

}  // namespace

Result<StoredModel> open_stored_model(const std::filesystem::path& store, Recipe recipe,
                                      const StoredModelSettings& settings) {
  CompileOptions& options = recipe.options;
  if (settings.level)
    if (Result<Done> done = lower_level(store, *settings.level, options); !done)
      return Error{done.error()};
  if (!settings.border_views) options.border_views = 0;
  const int threads = settings.jobs > 0 ? settings.jobs : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const Scene& scene = recipe.scene;
  Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return Error{fmt::format("{}: {}", store.string(), renderer.error())};
  Result<Subdivision> subdivision = subdivided(
      store, recipe,
      {renderer.value(), scene.studio, options, nullptr, settings.show_progress, settings.stop});
  if (!subdivision) return Error{subdivision.error()};
  std::vector<Cluster> clusters = find_clusters(subdivision.value(), options);
  if (clusters.empty())
    return Error{fmt::format("{}: has no aspects at level {}; compile the scene deeper",
                             store.string(), options.level)};
  SphereClasses sphere_classes = divide_borders(subdivision.value(), options, clusters);
  auto [types, classes] = describe_classes(subdivision.value(), clusters, options);
  return StoredModel{
      std::move(recipe),   std::move(renderer).value(), std::move(subdivision).value(),
      std::move(clusters), std::move(sphere_classes),   std::move(types),
      std::move(classes)};
}

}  // namespace aspect
