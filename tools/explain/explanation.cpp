#include "tools/explain/explanation.h"

#include <algorithm>

#include "compiler/compile.h"
#include "compiler/scene/scene_reader.h"
#include "tools/doctor/colour_crowd.h"
#include "tools/explain/background_advice.h"
#include "tools/explain/blind_spots.h"
#include "tools/explain/colour_cure.h"
#include "tools/explain/confusions.h"

namespace aspect {
namespace {

// Colours are merged of meshes alone.
std::optional<CrowdedColours> crowded_colours(const EvaluatedObject& object, const Scene& scene,
                                              const VisionParameters& vision) {
  if (scene.file.empty() || lower_extension(scene.file) == ".b") return std::nullopt;
  const ColourGroups groups = colour_groups(scene);
  const Sight sight = look_around(scene, object.renderer, groups, vision, scene.studio.distance);
  const ColourCrowd crowd = find_crowd(groups, sight, vision);
  if (!crowd.is_one()) return std::nullopt;
  return CrowdedColours{groups.groups.size(), crowd.share, crowd.enough};
}

// As large as frames of many cameras; larger ones tell nothing more of colours.
Result<BackgroundPictures> pictures_for(const ExplainSettings& settings,
                                        const VisionParameters& vision) {
  constexpr int kLongest_px = 640;
  if (settings.backgrounds.empty()) return BackgroundPictures{};
  if (vision.sensor != SensorKind::colour)
    return Error{settings.backgrounds.native() +
                 ": backgrounds are compared by their colours, which the model's sensor does not "
                 "see; leave --backgrounds out"};
  return read_backgrounds(settings.backgrounds, kLongest_px);
}

std::vector<TriedView> tried_views(const std::vector<Trial>& trials) {
  std::vector<TriedView> views;
  for (const Trial& trial : trials) {
    TriedView& view = views.emplace_back(TriedView{trial.outcome.direction,
                                                   trial.outcome.right_class,
                                                   {},
                                                   trial.outcome.error_deg,
                                                   trial.right_aspect,
                                                   trial.is_wrong()});
    if (trial.found) view.taken_for = trial.found_class;
  }
  return views;
}

Result<Explanation> put_to_test(ClassIndex index, const std::filesystem::path& store,
                                const Recipe& recipe, const ExplainSettings& settings,
                                const BackgroundPictures& pictures) {
  const CompileOptions& options = recipe.options;
  const Result<EvaluatedObject> made =
      EvaluatedObject::of(std::move(index), store.string(), recipe.scene);
  if (!made) return Error{made.error()};
  const EvaluatedObject& object = made.value();
  const VisionParameters& vision = options.vision;

  const Faces faces = faces_of(recipe.scene);
  const std::vector<Trial> trials = run_trials(object, faces, settings);
  Explanation e;
  e.object = object.index.object;
  e.store = store.string();
  e.views = settings.views;
  e.aspects = object.index.classes.size();
  e.symmetries = object.index.symmetries;
  e.symmetry_axes = object.index.symmetry_axes;
  e.accuracy = accuracy_of(trials);
  e.tried_views = tried_views(trials);
  for (const Trial& trial : trials) {
    if (trial.is_wrong()) ++e.wrong_views;
    if (!trial.is_wrong() && !trial.right_aspect) ++e.neighbour_views;
  }
  BlindSpots blind = find_blind_spots(object, faces, options);
  e.blind_share = blind.share;
  e.blind_spots = std::move(blind.spots);
  e.failing_spots = failing_spots(trials);
  e.faces = faces.all;
  e.confusions = aspect_confusions(trials, faces);
  e.face_confusions = face_confusions(trials, faces, vision);
  e.scene_file = recipe.scene.file;
  e.merged_colours = recipe.scene.merged_colours;
  e.crowded = crowded_colours(object, recipe.scene, vision);
  std::vector<PaletteColour> paints = palette();
  if (!settings.backgrounds.empty()) {
    paints = palette_before(pictures, vision);
    const std::span<const PaletteColour> usable = paints;
    e.backgrounds =
        background_colours(faces, pictures, usable.first(e.crowded ? 0 : paints.size()), vision);
  }
  if (e.crowded) return e;
  const std::vector<ColourChange> changes =
      colour_changes(e.face_confusions, faces, vision, paints);
  if (changes.empty()) return e;
  Result<Cure> cure = try_changes(recipe, changes, faces, trials, settings);
  if (!cure) return Error{cure.error()};
  e.cure = std::move(cure).value();
  return e;
}

}  // namespace

Result<Explanation> explain(const std::filesystem::path& store, const Recipe& recipe,
                            const ExplainSettings& settings) {
  // Before anything that takes time.
  const Result<BackgroundPictures> pictures = pictures_for(settings, recipe.options.vision);
  if (!pictures) return Error{pictures.error()};
  CompileOptions options = recipe.options;
  options.jobs = settings.jobs;
  const Result<CompiledIndex> compiled = compile(recipe.scene, options, store, {}, nullptr);
  if (!compiled) return Error{compiled.error()};
  Result<ClassIndex> index =
      parse_index(std::as_bytes(std::span(compiled.value().bytes)), store.string());
  if (!index) return Error{index.error()};
  return put_to_test(std::move(index).value(), store, recipe, settings, pictures.value());
}

Result<Explanation> explain(ClassIndex index, const std::filesystem::path& store,
                            const Recipe& recipe, const ExplainSettings& settings) {
  const Result<BackgroundPictures> pictures = pictures_for(settings, recipe.options.vision);
  if (!pictures) return Error{pictures.error()};
  return put_to_test(std::move(index), store, recipe, settings, pictures.value());
}

}  // namespace aspect
