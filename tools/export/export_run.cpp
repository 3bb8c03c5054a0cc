#include "tools/export/export_run.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include "compiler/aspects/portions.h"
#include "compiler/stored_model.h"
#include "tools/aspectc/project/store_recipe.h"
#include "tools/export/described_view.h"
#include "tools/export/export_folder.h"
#include "tools/export/formats/means_file.h"
#include "tools/export/model_files.h"
#include "tools/replay/console.h"

namespace aspect {
namespace {

constexpr const char* kStopped = "stopped before anything was replaced; run it again";

Result<StoredModel> open_model(const ExportOptions& options, const std::atomic<bool>* stop) {
  Result<Recipe> recipe = recipe_of_store(options.store, options.scene);
  if (!recipe) return Error{recipe.error()};
  StoredModelSettings settings;
  settings.level = options.level;
  settings.border_views = !options.without_borders;
  settings.jobs = options.jobs;
  settings.stop = stop;
  return open_stored_model(options.store, std::move(recipe).value(), settings);
}

// The views one after the other: graphs and chain codes as files, attributes kept.
class ViewExport {
 public:
  ViewExport(const ExportOptions& options, const StoredModel& model, ExportFolder& folder)
      : options_(options),
        model_(model),
        folder_(folder),
        names_(view_names_of(model)),
        observers_([&model] {
          return Observer(model.renderer, model.recipe.scene.studio, model.recipe.options.vision);
        }) {}

  const std::vector<std::string>& names() const { return names_; }
  const ViewAttributes& attributes() const { return attributes_; }

  Result<Done> run(const std::atomic<bool>* stop, Console& console) {
    const std::vector<ObservedView>& views = model_.subdivision.views;
    attributes_.resize(views.size());
    described_.resize(views.size());
    Result<Done> done = run_in_portions(
        views.size(), stop, [&](std::size_t v) { described_[v] = described(v); },
        [&](std::size_t v) { return keep(v); },
        [&](std::size_t v) { console.progress(v, views.size(), "views"); });
    if (done.ok() && stop != nullptr && stop->load()) return Error{kStopped};
    return done;
  }

 private:
  struct Described {
    bool differs = false;  // from the store's
    std::vector<DescribedContour> contours;
  };

  Described described(std::size_t v) {
    const ObservedView& known = model_.subdivision.views[v];
    Observer& observer = observers_.local();
    if (!looks_the_same(observer.observe(known.direction), known)) return {true, {}};
    return {false, described_contours(observer)};
  }

  Result<Done> keep(std::size_t v) {
    const Described view = std::exchange(described_[v], {});
    if (view.differs)
      return Error{fmt::format(
          "{}: its view {} looks otherwise when it is rendered again, as on another machine; "
          "compile the scene again here",
          options_.store.string(), names_[v])};
    const ObservedView& known = model_.subdivision.views[v];
    for (std::size_t i = 0; i < known.external_count; ++i)
      attributes_[v].push_back(view.contours[i].attributes);
    const std::string stem = model_.recipe.scene.name + names_[v];
    if (options_.wants("sgm"))
      if (auto done = folder_.add(stem + ".sgm", graph_text(graph_of(known, view.contours))); !done)
        return done;
    if (!options_.wants("chn8")) return Done{};
    std::vector<ContourChain> chains;
    for (const DescribedContour& contour : view.contours) chains.push_back(contour.chain);
    return folder_.add(stem + ".chn8", chains_text(chains));
  }

  const ExportOptions& options_;
  const StoredModel& model_;
  ExportFolder& folder_;
  std::vector<std::string> names_;
  ViewAttributes attributes_;
  std::vector<Described> described_;
  tbb::enumerable_thread_specific<Observer> observers_;
};

bool needs_pictures(const ExportOptions& options) {
  return options.wants("sgm") || options.wants("chn8") || options.wants("det") ||
         options.wants("attr") || options.wants("means");
}

// The files of the whole model.
Result<Done> add_model_files(const ExportOptions& options, const StoredModel& model,
                             const ViewExport& views, ExportFolder& folder) {
  const std::string& name = model.recipe.scene.name;
  const auto add = [&](std::string_view format, const auto& text_of) -> Result<Done> {
    const bool by_level = format == "vert" || format == "part" || format == "det";
    const std::string level = by_level ? fmt::format(".{}", model.recipe.options.level) : "";
    if (!options.wants(format)) return Done{};
    return folder.add(fmt::format("{}{}.{}", name, level, format), text_of());
  };
  if (auto d = add("vert", [&] { return vertices_text(vertices_of(model)); }); !d) return d;
  if (auto d = add("part", [&] { return partitions_text(partitions_of(model)); }); !d) return d;
  if (options.wants("det") || options.wants("attr")) {
    const auto details = details_of(model, views.names(), views.attributes());
    if (auto d = add("det", [&] { return details_text(details); }); !d) return d;
    if (auto d = add("attr", [&] { return attributes_text(attributes_of(details)); }); !d) return d;
  }
  if (auto d = add("means", [&] { return means_text(means_of(model, views.attributes())); }); !d)
    return d;
  return add("class", [&] { return classes_text(classes_of(model)); });
}

Result<Done> export_model(const ExportOptions& options, const std::atomic<bool>* stop,
                          Console& console) {
  Result<ExportFolder> opened = ExportFolder::open(options.folder);
  if (!opened) return Error{opened.error()};
  ExportFolder& folder = opened.value();
  const Result<StoredModel> model = open_model(options, stop);
  if (!model) return Error{model.error()};
  ViewExport views(options, model.value(), folder);
  if (needs_pictures(options))
    if (Result<Done> done = views.run(stop, console); !done) return done;
  if (Result<Done> done = add_model_files(options, model.value(), views, folder); !done)
    return done;
  if (stop != nullptr && stop->load()) return Error{kStopped};
  const std::size_t files = folder.files(), bytes = folder.bytes();
  if (Result<Done> done = folder.commit(); !done) return done;
  fmt::print("{} level {}: {} views, {} classes, {} types; {} files, {:.1f} MiB in {}\n",
             model.value().recipe.scene.name, model.value().recipe.options.level,
             model.value().subdivision.views.size(), model.value().clusters.size(),
             model.value().types.size(), files, static_cast<double>(bytes) / (1 << 20),
             options.folder.string());
  return Done{};
}

}  // namespace

int run_export(const ExportOptions& options, const std::atomic<bool>* stop) {
  Console console("aspect-export");
  const int threads = options.jobs > 0 ? options.jobs : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const Result<Done> done = export_model(options, stop, console);
  if (!done) console.fail(done.error());
  return done.ok() ? 0 : 1;
}

}  // namespace aspect
