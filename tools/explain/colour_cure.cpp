#include "tools/explain/colour_cure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compiler/compile.h"

namespace aspect {
namespace {

constexpr std::size_t kMostChanges = 3;
constexpr double kSeparate = 2;  // colours farther apart than this are not what confuses
// Then no pixel of usual brightness is within kColourReach of both: the difference of their shares
// is more than twice that.
constexpr double kFarApart = 4;
constexpr double kLeastViews = 0.25;  // of those of the most frequent pair, to be worth a change

double least_separation(const Eigen::Vector3d& colour, std::size_t changed,
                        const std::vector<Eigen::Vector3d>& colours,
                        const VisionParameters& vision) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < colours.size(); ++k)
    if (k != changed) least = std::min(least, colour_separation(colour, colours[k], vision));
  return least;
}

}  // namespace

std::vector<PaletteColour> palette() {
  constexpr std::array kNames = {"red",  "orange", "yellow", "lime",   "green",   "mint",
                                 "cyan", "sky",    "blue",   "violet", "magenta", "rose"};
  std::vector<PaletteColour> colours;
  for (const double saturation : {0.9, 0.5}) {
    for (std::size_t k = 0; k < kNames.size(); ++k) {
      Eigen::Vector3d colour;
      for (Eigen::Index channel = 0; channel < 3; ++channel) {
        // Each channel is full a third of the way round, and none half the way.
        const double turn =
            std::fmod(static_cast<double>(k) / 12 - static_cast<double>(channel) / 3 + 1.5, 1.0);
        const double full = std::clamp(2 - std::abs(turn - 0.5) * 6, 0.0, 1.0);
        colour[channel] = 0.85 * (1 - saturation * (1 - full));
      }
      colours.push_back({kNames[k], colour, {}});
    }
  }
  colours.push_back({"grey", Eigen::Vector3d(.6, .6, .6), {}});
  return colours;
}

std::optional<BetterPaint> best_paint(std::span<const PaletteColour> palette, std::size_t changed,
                                      const std::vector<Eigen::Vector3d>& colours,
                                      const VisionParameters& vision) {
  std::optional<BetterPaint> best;
  const auto is_better = [](const BetterPaint& a, const BetterPaint& b) {
    const bool a_is_far = a.separation > kFarApart, b_is_far = b.separation > kFarApart;
    if (a_is_far != b_is_far) return a_is_far;
    if (a.paint.commonness != b.paint.commonness) return a.paint.commonness < b.paint.commonness;
    return a.separation > b.separation;
  };
  for (const PaletteColour& paint : palette) {
    const BetterPaint candidate{paint, least_separation(paint.colour, changed, colours, vision)};
    if (!best || is_better(candidate, *best)) best = candidate;
  }
  return best;
}

std::vector<ColourChange> colour_changes(const std::vector<FaceConfusion>& confusions,
                                         const Faces& faces, const VisionParameters& vision,
                                         std::span<const PaletteColour> palette) {
  std::vector<Eigen::Vector3d> colours;
  for (const Face& face : faces.all) colours.push_back(face.colour);
  std::vector<std::size_t> involved(faces.all.size(), 0);
  for (const FaceConfusion& c : confusions) {
    involved[c.face] += c.views;
    involved[c.taken_for] += c.views;
  }
  std::vector<ColourChange> changes;
  const auto is_changed = [&](std::size_t face) {
    return std::any_of(changes.begin(), changes.end(),
                       [&](const ColourChange& change) { return change.face == face; });
  };
  std::size_t most = 0;
  for (const FaceConfusion& c : confusions) {
    if (changes.size() == kMostChanges) break;
    if (c.separation > kSeparate || is_changed(c.face) || is_changed(c.taken_for)) continue;
    most = std::max(most, c.views);
    if (static_cast<double>(c.views) < kLeastViews * static_cast<double>(most)) break;
    ColourChange change;
    change.face = involved[c.face] > involved[c.taken_for] ? c.face : c.taken_for;
    if (const auto best = best_paint(palette, change.face, colours, vision)) {
      change.separation = best->separation;
      change.colour = best->paint.colour;
      change.colour_name = best->paint.name;
    }
    if (change.separation <= c.separation) continue;
    colours[change.face] = change.colour;
    changes.push_back(change);
  }
  return changes;
}

Result<Cure> try_changes(const Recipe& recipe, const std::vector<ColourChange>& changes,
                         const Faces& faces, const std::vector<Trial>& before,
                         const ExplainSettings& settings) {
  Cure cure;
  cure.changes = changes;
  Scene scene = recipe.scene;
  for (const ColourChange& change : changes) paint(scene, faces.all[change.face], change.colour);
  CompileOptions options = recipe.options;
  options.jobs = settings.jobs;
  const auto compiled_at = [&](int level) {
    options.level = cure.level = level;
    options.min_level = std::min(recipe.options.min_level, level);
    return compile(scene, options, std::nullopt, {}, nullptr);
  };
  Result<CompiledIndex> compiled = compiled_at(std::min(options.level, settings.cure_level));
  // Of an object with much detail no patch is uniform at a low level.
  while (!compiled && cure.level < recipe.options.level) compiled = compiled_at(cure.level + 1);
  if (!compiled) return Error{compiled.error()};
  Result<ClassIndex> index =
      parse_index(std::as_bytes(std::span(compiled.value().bytes)), scene.name);
  if (!index) return Error{index.error()};
  const Result<EvaluatedObject> object =
      EvaluatedObject::of(std::move(index).value(), scene.name, scene);
  if (!object) return Error{object.error()};
  const std::vector<Trial> after = run_trials(object.value(), faces, settings);
  cure.after = accuracy_of(after);
  for (std::size_t k = 0; k < after.size(); ++k) {
    cure.wrong_before += before[k].is_wrong() ? 1U : 0U;
    cure.wrong_after += after[k].is_wrong() ? 1U : 0U;
    cure.cured += before[k].is_wrong() && !after[k].is_wrong() ? 1U : 0U;
  }
  return cure;
}

}  // namespace aspect
