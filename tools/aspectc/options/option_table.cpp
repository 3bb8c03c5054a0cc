#include "tools/aspectc/options/option_table.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "runtime/base/check.h"
#include "runtime/recognition/class_match.h"
#include "runtime/service/segmentation_values.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

constexpr std::string_view kCamera = "camera", kLight = "light", kMesh = "mesh",
                           kSegmentation = "segmentation", kRelations = "relations",
                           kMatching = "matching", kSubdivision = "subdivision",
                           kClasses = "classes", kIndex = "index", kRun = "run";

// In the order of the enumerations.
constexpr std::array<std::string_view, 3> kScorings = {"none", "views", "area"};

constexpr std::array<std::string_view, 3> kRelationChoices = {"nearest", "importance", "tree"};

// Far beyond any lens or object; it keeps the arithmetic of projections from overflowing.
constexpr double kMost = 1e6, kLeast = 1e-6;

constexpr std::size_t kKiB = 1024;

template <typename Member>
struct InnerType {
  using Type = Member;
};
template <typename Member>
struct InnerType<std::optional<Member>> {
  using Type = Member;
};

// Sizes are bytes in memory and KiB for people.
OptionValue shown(std::size_t bytes) {
  return static_cast<int>(bytes / kKiB);
}
// The shortest text of a float is that of the double with the same digits.
OptionValue shown(float number) {
  return std::stod(fmt::to_string(number));
}
template <typename Member>
OptionValue shown(const Member& member) {
  if constexpr (std::is_enum_v<Member>)
    return static_cast<int>(member);
  else
    return member;
}

template <typename Member>
std::optional<OptionValue> read_member(const Member& member) {
  return shown(member);
}
template <typename Member>
std::optional<OptionValue> read_member(const std::optional<Member>& member) {
  return member ? std::optional(shown(*member)) : std::nullopt;
}

template <typename Member>
void write_member(Member& member, const OptionValue& value) {
  using Inner = typename InnerType<Member>::Type;
  if constexpr (std::is_same_v<Inner, std::size_t>)
    member = static_cast<std::size_t>(std::get<int>(value)) * kKiB;
  else if constexpr (std::is_same_v<Inner, float>)
    member = static_cast<float>(std::get<double>(value));
  else if constexpr (std::is_enum_v<Inner>)
    member = static_cast<Inner>(std::get<int>(value));
  else
    member = std::get<Inner>(value);
}

// `access` names the member: a lambda without captures that returns a reference to it.
template <typename Access>
Option option(const OptionText& text, const OptionForm& form, Access /*access*/) {
  return {text, form, false,
          [](const CompileSettings& settings) { return read_member(Access{}(settings)); },
          [](CompileSettings& settings, const OptionValue& value) {
            write_member(Access{}(settings), value);
          }};
}

template <typename Access>
Option project_option(const OptionText& text, const OptionForm& form, Access access) {
  Option result = option(text, form, access);
  result.project_wide = true;
  return result;
}

void add_camera(std::vector<Option>& all) {
  all.push_back(option(
      {kCamera, "width", "--width", "px", "width of the pictures",
       "as the camera's, up to 512: time grows with the area"},
      WholeForm{{16, kMaxFrameSide_px}}, [](auto& s) -> auto& { return s.camera.width_px; }));
  all.push_back(option(
      {kCamera, "height", "--height", "px", "height of the pictures", ""},
      WholeForm{{16, kMaxFrameSide_px}}, [](auto& s) -> auto& { return s.camera.height_px; }));
  all.push_back(option(
      {kCamera, "field_of_view_deg", "--field-of-view-deg", "degrees",
       "full horizontal field of view, unless focal lengths are given", "lenses have 30 to 80"},
      NumberForm{{0.1, 179}}, [](auto& s) -> auto& { return s.camera.field_of_view_deg; }));
  all.push_back(option(
      {kCamera, "fx", "--fx", "px", "focal length along a row",
       "with fy instead of the field of view, from a calibration"},
      NumberForm{{1, kMost}}, [](auto& s) -> auto& { return s.camera.fx_px; }));
  all.push_back(option(
      {kCamera, "fy", "--fy", "px", "focal length along a column", ""}, NumberForm{{1, kMost}},
      [](auto& s) -> auto& { return s.camera.fy_px; }));
  all.push_back(option(
      {kCamera, "cx", "--cx", "px", "column of the principal point",
       "pixel centres are at whole numbers; the middle is (width - 1) / 2"},
      NumberForm{{-kMost, kMost}}, [](auto& s) -> auto& { return s.camera.cx_px; }));
  all.push_back(option(
      {kCamera, "cy", "--cy", "px", "row of the principal point", ""}, NumberForm{{-kMost, kMost}},
      [](auto& s) -> auto& { return s.camera.cy_px; }));
  all.push_back(option(
      {kCamera, "distance", "--distance", "scene units",
       "nearest and farthest distance of the camera from the point that it looks at",
       "compiled at their geometric mean; the farther they are apart the less alike the views"},
      NumbersForm{2, {kLeast, kMost}}, [](auto& s) -> auto& { return s.camera.distance; }));
}

void add_light(std::vector<Option>& all) {
  all.push_back(option(
      {kLight, "ambient", "--ambient", "r, g, b", "light that is everywhere",
       "with 1, 1, 1 and no lamps every surface has one colour: the most robust segmentation"},
      NumbersForm{3, {0, 1000}}, [](auto& s) -> auto& { return s.light.ambient; }));
}

void add_mesh(std::vector<Option>& all) {
  all.push_back(option(
      {kMesh, "missing_colour", "--missing-colour", "r, g, b",
       "stands for colours that the scene names and that are not found",
       "without it a missing library, material, picture or name is an error"},
      NumbersForm{3, {0, 1}}, [](auto& s) -> auto& { return s.mesh.missing_colour; }));
  all.push_back(option(
      {kMesh, "merge_colours", "--merge-colours", "",
       "most colours of a mesh, into which all that it has are merged [as many as it has]",
       "4 to 12 for one that was scanned or shaded; aspectc doctor shows it in so many"},
      WholeForm{{2, 256}}, [](auto& s) -> auto& { return s.mesh.merge_colours; }));
}

void add_tessellation(std::vector<Option>& all) {
  all.push_back(option(
      {kMesh, "chord_error", "--chord-error", "of the diagonal of its box",
       "largest distance of a STEP file's triangles from its surfaces",
       "0.0003 to 0.003; half of it has twice the triangles"},
      NumberForm{{1e-5, 0.1}}, [](auto& s) -> auto& { return s.mesh.chord_error; }));
}

// What suits one sensor does not suit another: all of the segmentation follows it, and is then
// changed by the options that come after it.
void choose_sensor(CompileSettings& settings, const OptionValue& value) {
  VisionParameters& vision = settings.options.vision;
  const auto sensor = static_cast<SensorKind>(std::get<int>(value));
  if (sensor == vision.sensor) return;
  const VisionParameters before = vision;
  vision = default_parameters(sensor);
  vision.relation_choice = before.relation_choice;
  vision.relations_max = before.relations_max;
}

OptionForm form_of(const SegmentationValue& value) {
  if (std::holds_alternative<std::optional<bool> SegmentationOverrides::*>(value.member))
    return TruthForm{};
  if (std::holds_alternative<std::optional<float> SegmentationOverrides::*>(value.member))
    return NumberForm{{value.least, value.most}};
  return WholeForm{{static_cast<int>(value.least), static_cast<int>(value.most)}};
}

// A value that configurations have as well, in the words that they have for it.
template <typename Access>
void add_shared(std::vector<Option>& all, std::string_view key, std::string_view flag,
                Access access) {
  const SegmentationValue* value = find_segmentation_value(key);
  ASPECT_CHECK(value != nullptr);
  all.push_back(
      option({kSegmentation, value->key, flag, value->unit, value->meaning, value->advice},
             form_of(*value), access));
}

void add_range(std::vector<Option>& all) {
  add_shared(
      all, "range_step_length", "--range-step-length",
      [](auto& s) -> auto& { return s.options.vision.range.step_length; });
  add_shared(
      all, "range_steps_min", "--range-steps-min",
      [](auto& s) -> auto& { return s.options.vision.range.steps_min; });
  add_shared(
      all, "range_steps_max", "--range-steps-max",
      [](auto& s) -> auto& { return s.options.vision.range.steps_max; });
  add_shared(
      all, "range_depth_step", "--range-depth-step",
      [](auto& s) -> auto& { return s.options.vision.range.depth_step; });
  add_shared(
      all, "range_normal_step_deg", "--range-normal-step-deg",
      [](auto& s) -> auto& { return s.options.vision.range.normal_step_deg; });
}

void add_segmentation(std::vector<Option>& all) {
  Option sensor = option(
      {kSegmentation, "sensor", "--sensor", "", "what frames are of",
       "colours, grey values, depths or surface ids; the defaults below follow it"},
      WordForm{kSensorNames}, [](auto& s) -> auto& { return s.options.vision.sensor; });
  sensor.set = choose_sensor;
  all.push_back(std::move(sensor));
  add_shared(
      all, "intensity_min", "--intensity-min",
      [](auto& s) -> auto& { return s.options.vision.intensity_min; });
  add_shared(
      all, "chroma_step", "--chroma-step",
      [](auto& s) -> auto& { return s.options.vision.chroma_step; });
  add_shared(
      all, "noise_steps", "--noise-steps",
      [](auto& s) -> auto& { return s.options.vision.noise_steps; });
  add_shared(
      all, "intensity_step", "--intensity-step",
      [](auto& s) -> auto& { return s.options.vision.intensity_step; });
  add_shared(
      all, "area_min_px", "--area-min-px",
      [](auto& s) -> auto& { return s.options.vision.area_min_px; });
  add_shared(
      all, "thickness_min_px", "--thickness-min-px",
      [](auto& s) -> auto& { return s.options.vision.thickness_min_px; });
  add_shared(
      all, "smooth", "--smooth", [](auto& s) -> auto& { return s.options.vision.smooth; });
  add_range(all);
}

void add_relations(std::vector<Option>& all) {
  all.push_back(option(
      {kRelations, "choice", "--relations", "", "which arcs of the graph come first",
       "the shortest, those between large contours, or a spanning tree and then the shortest"},
      WordForm{kRelationChoices},
      [](auto& s) -> auto& { return s.options.vision.relation_choice; }));
  all.push_back(option(
      {kRelations, "count", "--relations-count", "",
       "arcs of the graph kept for each object; 0: all", "fewer match faster and tell less"},
      WholeForm{{0, kMaxRelations}},
      [](auto& s) -> auto& { return s.options.vision.relations_max; }));
}

void add_matching(std::vector<Option>& all) {
  const auto add_scale = [&](std::string_view key, std::string_view flag, std::string_view unit,
                             std::string_view meaning, auto access) {
    all.push_back(option({kMatching, key, flag, unit, meaning,
                          "the attribute's weight is 1 / scale^2: higher tolerates more"},
                         NumberForm{{kLeast, kMost}}, access));
  };
  add_scale(
      "share", "--share-scale", "of 1", "difference of a colour share that costs one step",
      [](auto& s) -> auto& { return s.options.match_scales.share; });
  add_scale(
      "area", "--area-scale", "of the outline's area", "the same of a contour's area",
      [](auto& s) -> auto& { return s.options.match_scales.area; });
  add_scale(
      "position", "--position-scale", "square roots of the outline's area",
      "the same of a contour's position",
      [](auto& s) -> auto& { return s.options.match_scales.position; });
  add_scale(
      "second", "--second-scale", "of the outline's area", "the same of a contour's second moments",
      [](auto& s) -> auto& { return s.options.match_scales.second; });
  add_scale(
      "direction", "--direction-scale", "sixteenths of a turn",
      "the same of the direction between two contours",
      [](auto& s) -> auto& { return s.options.match_scales.direction; });
  add_scale(
      "kind", "--kind-scale", "arcs", "the same of inside against outside and so on",
      [](auto& s) -> auto& { return s.options.match_scales.kind; });
  all.push_back(option(
      {kMatching, "limit_ms", "--match-limit-ms", "ms", "search time of one match; 0: any",
       "0, since with a limit the result depends on the machine; 1000 ends a run that hangs"},
      NumberForm{{0, kMost}}, [](auto& s) -> auto& { return s.options.match_limit_ms; }));
}

void add_subdivision(std::vector<Option>& all) {
  all.push_back(option(
      {kSubdivision, "min_level", "--min-level", "",
       "level up to which every patch of the viewing sphere is split",
       "3; higher finds smaller aspects, each step costs four times the views"},
      WholeForm{{0, 10}}, [](auto& s) -> auto& { return s.options.min_level; }));
  all.push_back(option(
      {kSubdivision, "level", "--level", "", "finest level of the patches",
       "4 to 7; each step halves the uncovered area and doubles the views"},
      WholeForm{{0, 10}}, [](auto& s) -> auto& { return s.options.level; }));
  all.push_back(option(
      {kSubdivision, "threshold", "--threshold", "match cost",
       "largest match cost between the views of a patch that is not split",
       "10000: one step in every contour; higher: fewer views, until aspects merge"},
      NumberForm{{1e-3, 1e15}}, [](auto& s) -> auto& { return s.options.threshold; }));
  all.push_back(option(
      {kSubdivision, "stop_area", "--stop-area", "of the sphere",
       "splitting ends where this share lies in uniform patches; 1: at the finest level",
       "0.9 to 0.98; higher finds narrower aspects and takes more views"},
      NumberForm{{kLeast, 1}}, [](auto& s) -> auto& { return s.options.stop_area; }));
  all.push_back(option(
      {kSubdivision, "border_views", "--border-views", "",
       "most views that are spent on dividing patches along borders; 0: such patches are left out",
       "40000 lets objects of ten surfaces cover 98 % of the sphere and more"},
      WholeForm{{0, 10'000'000}}, [](auto& s) -> auto& { return s.options.border_views; }));
}

void add_classes(std::vector<Option>& all) {
  all.push_back(option(
      {kClasses, "cluster_threshold", "--cluster-threshold", "match cost",
       "largest match cost between the views of one class; at least --threshold",
       "100000; higher: fewer, larger classes, until different aspects merge"},
      NumberForm{{1e-3, 1e15}}, [](auto& s) -> auto& { return s.options.cluster_threshold; }));
  all.push_back(option(
      {kClasses, "small_cluster_fraction", "--small-cluster-fraction,--small-cluster",
       "of the sphere", "clusters that cover less are discarded as noise",
       "0.0004; higher: a smaller index that misses narrow aspects"},
      NumberForm{{0, 1}}, [](auto& s) -> auto& { return s.options.small_cluster_fraction; }));
  all.push_back(option(
      {kClasses, "types", "--types", "", "contour types, K of the k-means",
       "40 to 100; higher tells more contours apart and makes the index larger"},
      WholeForm{{1, static_cast<int>(kMaxTypes)}},
      [](auto& s) -> auto& { return s.options.contour_types; }));
  all.push_back(option(
      {kClasses, "scoring", "--scoring", "",
       "score of a contour type: none, by views, or by their area", ""},
      WordForm{kScorings}, [](auto& s) -> auto& { return s.options.scoring; }));
}

void add_index(std::vector<Option>& all) {
  all.push_back(option(
      {kIndex, "max_kib", "--max-index-kib", "KiB", "largest size of an index",
       "10 to 100; lower keeps fewer key views, then fewer classes"},
      WholeForm{{1, 16384}}, [](auto& s) -> auto& { return s.options.max_index_bytes; }));
  all.push_back(project_option(
      {kIndex, "combined", "--combined", "", "all objects of the project in one file, not one each",
       "the runtime takes either"},
      TruthForm{}, [](auto& s) -> auto& { return s.combined; }));
}

void add_run(std::vector<Option>& all) {
  all.push_back(project_option(
      {kRun, "jobs", "--jobs", "", "threads [one a core]", "changes no result"},
      WholeForm{{1, 1024}}, [](auto& s) -> auto& { return s.jobs; }));
}

std::vector<Option> all_options() {
  std::vector<Option> all;
  for (const auto add :
       {add_camera, add_light, add_mesh, add_tessellation, add_segmentation, add_relations,
        add_matching, add_subdivision, add_classes, add_index, add_run})
    add(all);
  return all;
}

}  // namespace

std::span<const Option> compile_option_table() {
  static const std::vector<Option> kAll = all_options();
  return kAll;
}

const Option* find_option(std::string_view table, std::string_view key) {
  const auto all = compile_option_table();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Option& option) {
    return option.text.table == table && option.text.key == key;
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace aspect
