#include "tools/eval/clutter_run.h"

#include <algorithm>
#include <cstdio>

#include "tools/aspectc/commands/whole_file.h"
#include "tools/eval/background_pictures.h"
#include "tools/eval/clutter_dump.h"
#include "tools/eval/clutter_report.h"
#include "tools/eval/plots.h"
#include "tools/eval/recall_svg.h"

namespace aspect {
namespace {

// As large as frames: pieces of them are made no larger than twice.
Result<BackgroundPictures> backgrounds_for(std::span<const EvaluatedObject> objects,
                                           const std::filesystem::path& folder) {
  if (folder.empty()) return BackgroundPictures{};
  int longest_px = 0;
  for (const EvaluatedObject& object : objects)
    longest_px =
        std::max({longest_px, object.scene.studio.width_px, object.scene.studio.height_px});
  return read_backgrounds(folder, longest_px + longest_px / 4);
}

std::optional<Error> evaluate(std::span<const EvaluatedObject> objects, const EvalOptions& options,
                              const ClutterSettings& settings, std::optional<ClutterDump>& dump,
                              ClutterEvaluation& evaluation, Console& console) {
  for (std::size_t place = 0; place < objects.size(); ++place) {
    const EvaluatedObject& object = objects[place];
    FrameTaker take = [&](std::size_t number, const ClutteredFrame& frame) {
      console.progress(place * static_cast<std::size_t>(options.views) + number + 1,
                       objects.size() * static_cast<std::size_t>(options.views),
                       object.index.object);
      return dump ? dump->add(object.index.object, number, object.scene, frame) : std::nullopt;
    };
    Result<ObjectClutter> clutter =
        evaluate_clutter(objects, place, evaluation.settings, settings, take);
    if (!clutter) return Error{clutter.error()};
    evaluation.objects.push_back(std::move(clutter).value());
  }
  return dump ? dump->finish() : std::nullopt;
}

}  // namespace

void run_clutter(std::span<const EvaluatedObject> objects, const EvalOptions& options,
                 Console& console) {
  for (const EvaluatedObject& object : objects)
    if (const auto fault = clutter_fault(object)) return console.fail(fault->message);
  const Result<BackgroundPictures> pictures = backgrounds_for(objects, options.backgrounds);
  if (!pictures) return console.fail(pictures.error());
  std::optional<ClutterDump> dump;
  if (!options.dump.empty()) {
    Result<ClutterDump> made = ClutterDump::create(options.dump);
    if (!made) return console.fail(made.error());
    dump = std::move(made).value();
  }
  ClutterEvaluation evaluation;
  evaluation.settings = {options.views, options.seed, options.matching, options.ranking};
  evaluation.hidden_max = options.hidden_max;
  evaluation.backgrounds = pictures.value().folder;
  evaluation.pictures = pictures.value().rgb.size();
  const ClutterSettings settings{options.hidden_max, pictures.value().rgb};
  if (const auto error = evaluate(objects, options, settings, dump, evaluation, console))
    return console.fail(error->message);
  const std::string text = options.json ? clutter_json(evaluation) : clutter_text(evaluation);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    console.fail("standard output: cannot be written; check where it goes");
  if (!options.plots.empty())
    if (const auto fault = write_plots(evaluation, options.plots)) console.fail(fault->message);
  if (options.recall.empty()) return;
  if (const auto done = write_whole_text(options.recall, recall_svg(evaluation)); !done)
    console.fail(done.error());
}

}  // namespace aspect
