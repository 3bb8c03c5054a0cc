#include "tools/eval/evaluation_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "runtime/recognition/index_bundle.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/command_line/command_line.h"
#include "tools/eval/clutter_run.h"
#include "tools/eval/evaluation_json.h"
#include "tools/eval/evaluation_text.h"
#include "tools/eval/plots.h"
#include "tools/eval/reliability_svg.h"
#include "tools/replay/console.h"

namespace aspect {
namespace {

// The index does not tell which scene it was compiled from, but for the name and the camera.
void warn_of_misfit(const EvaluatedObject& object, const std::string& scene_file,
                    Console& console) {
  const ClassIndex& index = object.index;
  const Studio& studio = object.scene.studio;
  if (object.scene.name != index.object)
    console.warn(fmt::format("{}: was compiled from a scene named {}, not {}; check the pairs",
                             object.index_file, index.object, scene_file));
  else if (studio.width_px != index.width_px || studio.height_px != index.height_px ||
           std::abs(studio.angle_deg - static_cast<double>(index.field_of_view_deg)) > 1e-3)
    console.warn(
        fmt::format("{}: was compiled with another camera than {} has; compile the scene again",
                    object.index_file, scene_file));
}

// One for each object: a file may hold several.
struct NamedIndex {
  std::filesystem::path file;
  ClassIndex index;
};

std::vector<NamedIndex> load_index_files(const EvalOptions& options, Console& console) {
  std::vector<NamedIndex> all;
  for (const std::filesystem::path& file : options.indexes) {
    Result<std::vector<ClassIndex>> indexes = load_index_file(file);
    if (!indexes) {
      console.fail(indexes.error());
      continue;
    }
    for (ClassIndex& index : indexes.value()) all.push_back({file, std::move(index)});
  }
  return all;
}

std::vector<EvaluatedObject> load_objects(std::vector<NamedIndex> indexes,
                                          const EvalOptions& options, Console& console) {
  std::vector<EvaluatedObject> objects;
  for (std::size_t k = 0; k < indexes.size(); ++k) {
    const std::filesystem::path& file = indexes[k].file;
    Result<EvaluatedObject> object =
        EvaluatedObject::create(file, std::move(indexes[k].index), options.scenes[k]);
    if (!object) {
      console.fail(object.error());
      continue;
    }
    if (!objects.empty() &&
        objects.front().index.vision.sensor != object.value().index.vision.sensor) {
      console.fail(fmt::format("{}: compiled for another sensor than {}; leave one of them out",
                               options.indexes[k].native(), objects.front().index_file));
      continue;
    }
    const auto same = std::find_if(objects.begin(), objects.end(), [&](const auto& other) {
      return other.index.object == object.value().index.object;
    });
    if (same != objects.end()) {
      console.fail(fmt::format("{}: holds the object {} like {}; leave one of them out",
                               file.native(), same->index.object, same->index_file));
      continue;
    }
    warn_of_misfit(object.value(), options.scenes[k].native(), console);
    objects.push_back(std::move(object).value());
  }
  return objects;
}

void write_plot(const Evaluation& evaluation, const std::filesystem::path& file, Console& console) {
  const std::string svg = reliability_svg(overall_reliability(evaluation));
  if (const auto done = write_whole_text(file, svg); !done) console.fail(done.error());
}

// Before hours of work.
std::optional<Error> output_fault(const EvalOptions& options) {
  for (const std::filesystem::path& plot : {options.reliability, options.recall}) {
    if (plot.empty()) continue;
    if (const auto done = check_writable(plot); !done) return Error{done.error()};
  }
  return options.plots.empty() ? std::nullopt : prepare_plots(options.plots);
}

}  // namespace

int run_evaluation(const EvalOptions& options) {
  Console console("aspect-eval");
  const Result<ThesisRanks> thesis =
      options.thesis.empty() ? ThesisRanks{} : read_thesis_ranks(options.thesis);
  if (!thesis) console.fail(thesis.error());
  if (const auto fault = output_fault(options)) console.fail(fault->message);
  if (console.failures() > 0) return 1;
  std::vector<NamedIndex> indexes = load_index_files(options, console);
  if (console.failures() > 0) return 1;
  if (indexes.size() != options.scenes.size()) {
    console.fail(pairs_needed(indexes.size(), options.scenes.size()));
    return kUsageError;
  }
  const std::vector<EvaluatedObject> objects = load_objects(std::move(indexes), options, console);
  if (console.failures() > 0) return 1;
  if (options.clutter) {
    run_clutter(objects, options, console);
    return console.failures() > 0 ? 1 : 0;
  }
  Evaluation evaluation;
  evaluation.settings = {options.views, options.seed, options.matching, options.ranking};
  for (const EvaluatedObject& object : objects) {
    console.progress(evaluation.objects.size() + 1, objects.size(), object.index.object);
    evaluation.objects.push_back(evaluate_object(object, evaluation.settings));
  }
  if (objects.size() > 1) evaluation.confusion = evaluate_confusion(objects, evaluation.settings);
  const std::string text = options.json ? evaluation_json(evaluation) : evaluation_text(evaluation);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    console.fail("standard output: cannot be written; check where it goes");
  if (!options.reliability.empty()) write_plot(evaluation, options.reliability, console);
  if (!options.plots.empty())
    if (const auto fault = write_plots(evaluation, thesis.value(), options.plots))
      console.fail(fault->message);
  return console.failures() > 0 ? 1 : 0;
}

}  // namespace aspect
