#include "compiler/recipe.h"

#include <fmt/format.h>

#include <sstream>

#include "compiler/scene/bob_reader.h"
#include "compiler/scene/scene_reader.h"
#include "runtime/base/fnv1a.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/class_match.h"

namespace aspect {
namespace {

constexpr const char* kSceneFile = "scene_file";
constexpr const char* kSceneText = "scene_text";
constexpr const char* kOptions = "options";
constexpr const char* kMergedColours = "merged_colours";
constexpr const char* kChordError = "chord_error";

// Every option once, for writing and for reading.
template <typename Options, typename Visit>
void each_option(Options& o, const Visit& visit) {
  visit("level", o.level);
  visit("min_level", o.min_level);
  visit("threshold", o.threshold);
  visit("cluster_threshold", o.cluster_threshold);
  visit("small_cluster_fraction", o.small_cluster_fraction);
  visit("stop_area", o.stop_area);
  visit("border_views", o.border_views);
  visit("match_limit_ms", o.match_limit_ms);
  visit("contour_types", o.contour_types);
  visit("scoring", o.scoring);
  visit("max_index_bytes", o.max_index_bytes);
  auto& m = o.match_scales;
  visit("match.share", m.share);
  visit("match.area", m.area);
  visit("match.position", m.position);
  visit("match.second", m.second);
  visit("match.direction", m.direction);
  visit("match.kind", m.kind);
  auto& v = o.vision;
  visit("vision.intensity_min", v.intensity_min);
  visit("vision.chroma_step", v.chroma_step);
  visit("vision.noise_steps", v.noise_steps);
  visit("vision.intensity_step", v.intensity_step);
  visit("vision.area_min_px", v.area_min_px);
  visit("vision.thickness_min_px", v.thickness_min_px);
  visit("vision.smooth", v.smooth);
  visit("vision.relations_max", v.relations_max);
  visit("vision.relation_choice", v.relation_choice);
  visit("vision.sensor", v.sensor);
  auto& r = v.range;
  visit("range.step_length", r.step_length);
  visit("range.steps_min", r.steps_min);
  visit("range.steps_max", r.steps_max);
  visit("range.depth_step", r.depth_step);
  visit("range.normal_step_deg", r.normal_step_deg);
  visit("range.field_of_view_deg", r.field_of_view_deg);
}

int most_of(Scoring) {
  return static_cast<int>(Scoring::area);
}
int most_of(RelationChoice) {
  return static_cast<int>(RelationChoice::tree);
}
int most_of(SensorKind) {
  return static_cast<int>(kSensorNames.size()) - 1;
}

bool read_value(std::istream& words, auto& value) {
  using Value = std::remove_reference_t<decltype(value)>;
  if constexpr (std::is_enum_v<Value>) {
    int number = 0;
    words >> number;
    if (number < 0 || number > most_of(value)) return false;
    value = static_cast<Value>(number);
  } else {
    words >> value;
  }
  return !words.fail();
}

// What the command line would not let through either.
bool can_be(const CompileOptions& o) {
  return o.level >= 0 && o.level <= 10 && o.min_level >= 0 && o.min_level <= o.level &&
         o.threshold > 0 && o.cluster_threshold >= o.threshold && o.contour_types >= 1 &&
         o.contour_types <= static_cast<int>(kMaxTypes) && o.max_index_bytes <= kMaxIndexBytes &&
         o.vision.thickness_min_px >= 0;
}

std::string hash_text(const Scene& scene) {
  return fmt::format("{:016x}", scene_hash_of(scene));
}

Result<Scene> kept_scene(const Store& store, const std::string& hash) {
  const Result<std::string> text = store.note(kSceneText), file = store.note(kSceneFile);
  if (!text) return Error{text.error()};
  if (!file) return Error{file.error()};
  Result<Scene> from_text = parse_bob(text.value(), file.value());
  if (from_text.ok() && hash_text(from_text.value()) == hash) return from_text;
  const Result<std::string> merged = store.note(kMergedColours);
  if (!merged) return Error{merged.error()};
  SceneReading reading;
  std::size_t count = 0;
  if (std::istringstream(merged.value()) >> count && count > 0) reading.colours.merged = count;
  const Result<std::string> error = store.note(kChordError);
  if (!error) return Error{error.error()};
  double share = 0;
  if (std::istringstream(error.value()) >> share && share > 0) reading.chord_error = share;
  return read_scene(file.value(), reading);
}

}  // namespace

std::uint64_t scene_hash_of(const Scene& scene) {
  std::uint64_t hash = kFnv1aStart;
  for (const char c : scene.source) hash = fnv1a(hash, static_cast<std::uint8_t>(c));
  return hash;
}

StoreKey store_key_of(const Scene& scene, const CompileOptions& options) {
  return {hash_text(scene), options.store_key(), ASPECT_VERSION, scene.name};
}

std::string options_text(const CompileOptions& options) {
  std::string text;
  each_option(options, [&](const char* name, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value> || std::is_same_v<Value, bool>)
      text += fmt::format("{} {}\n", name, static_cast<int>(value));
    else
      text += fmt::format("{} {}\n", name, value);
  });
  return text;
}

Result<CompileOptions> parse_options(const std::string& text) {
  CompileOptions options;
  std::istringstream words(text);
  std::string name;
  while (words >> name) {
    bool known = false, good = true;
    each_option(options, [&](const char* option, auto& value) {
      if (name != option) return;
      known = true;
      good = read_value(words, value);
    });
    if (!known || !good)
      return Error{fmt::format("has an option {} that this version cannot read", name)};
  }
  if (!can_be(options)) return Error{"has options that cannot be"};
  return options;
}

Result<Done> keep_recipe(Store& store, const Scene& scene, const CompileOptions& options) {
  std::error_code unknown;
  const std::string file =
      scene.file.empty() ? "" : std::filesystem::absolute(scene.file, unknown).string();
  const std::string merged = scene.merged_colours ? std::to_string(*scene.merged_colours) : "";
  const std::string error = scene.chord_error ? fmt::format("{}", *scene.chord_error) : "";
  for (const auto& [name, text] : {std::pair{kSceneFile, file},
                                   {kSceneText, scene.source},
                                   {kOptions, options_text(options)},
                                   {kMergedColours, merged},
                                   {kChordError, error}})
    if (Result<Done> done = store.set_note(name, text); !done) return done;
  return Done{};
}

Result<Recipe> read_recipe(const std::filesystem::path& path, const std::optional<Scene>& given) {
  const Result<Store> store = Store::open_existing(path);
  if (!store) return Error{store.error()};
  const Result<StoreContents> contents = store.value().contents();
  if (!contents) return Error{contents.error()};
  if (contents.value().runs.empty())
    return Error{path.string() + ": its model is not complete; compile the scene again to go on"};
  const Result<std::string> text = store.value().note(kOptions);
  if (!text) return Error{text.error()};
  if (text.value().empty())
    return Error{path.string() + ": does not say how it was made; compile the scene again"};
  const Result<CompileOptions> options = parse_options(text.value());
  if (!options) return Error{path.string() + ": " + options.error() + "; compile the scene again"};
  const std::string& hash = contents.value().key.scene_hash;
  const Result<Scene> scene = given ? Result<Scene>(*given) : kept_scene(store.value(), hash);
  if (!scene) return Error{path.string() + ": its scene cannot be read again: " + scene.error()};
  if (hash_text(scene.value()) != hash)
    return Error{fmt::format(
        "{}: was made from another scene than {} holds now, or with a project's settings; name the "
        "project or compile it again",
        path.string(), scene.value().file)};
  return Recipe{scene.value(), options.value()};
}

}  // namespace aspect
