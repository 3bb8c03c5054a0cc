#include "tools/report/report_contents.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <system_error>

#include "compiler/index/index_budget.h"
#include "compiler/scene/scene_reader.h"
#include "runtime/service/recognition_json.h"
#include "tools/aspectc/project/store_recipe.h"
#include "tools/report/aspect_colours.h"

namespace aspect {
namespace {

// As many pictures as make some megabytes; at least one of every aspect.
constexpr std::size_t kMostPictures = 1200, kMostOfAspect = 8;

std::size_t pictures_of_each(std::size_t aspects) {
  return std::clamp<std::size_t>(kMostPictures / std::max<std::size_t>(aspects, 1), 1,
                                 kMostOfAspect);
}

// With the nearest axis upwards where the studio's own up is near one: planes of projection are
// those of the axes then, without roll.
Studio upright(Studio studio) {
  constexpr double kNear = 0.97;  // cosine of 14 degrees
  const Eigen::Vector3d up = studio.up.normalized();
  Eigen::Index axis = 0;
  if (up.cwiseAbs().maxCoeff(&axis) > kNear)
    studio.up = (up[axis] > 0 ? 1 : -1) * Eigen::Vector3d::Unit(axis);
  return studio;
}

// From the front, from above and from beside, whichever way is up.
Eigen::Vector3d overview_direction(const Eigen::Vector3d& up) {
  const Eigen::Vector3d along =
      std::abs(up.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d front = (along - along.dot(up) * up).normalized();
  return (0.75 * front - 0.5 * up.cross(front) + 0.45 * up).normalized();
}

// As the camera from there has them.
HalfSphereView half_towards(std::string name, const Eigen::Vector3d& direction,
                            const ReportContents& contents, const Renderer& renderer) {
  const Camera camera = camera_at(contents.studio, direction);
  return {std::move(name),
          {camera.camera_from_object.row(0), -camera.camera_from_object.row(1), direction},
          picture_from(direction, contents.studio, renderer, contents.recipe.options.vision)};
}

// In the thesis's order (Figure 4.8).
std::vector<HalfSphereView> six_halves(const ReportContents& contents, const Renderer& renderer) {
  std::vector<HalfSphereView> halves;
  for (const auto& [name, direction] : {std::pair{"z \u2265 0", Eigen::Vector3d(0, 0, 1)},
                                        {"z < 0", Eigen::Vector3d(0, 0, -1)},
                                        {"x < 0", Eigen::Vector3d(-1, 0, 0)},
                                        {"x \u2265 0", Eigen::Vector3d(1, 0, 0)},
                                        {"y < 0", Eigen::Vector3d(0, -1, 0)},
                                        {"y \u2265 0", Eigen::Vector3d(0, 1, 0)}})
    halves.push_back(half_towards(name, direction, contents, renderer));
  return halves;
}

IndexWithoutBudget without_budget(const ReportContents& contents) {
  const LearntModel& model = contents.model;
  CompileOptions options = contents.recipe.options;
  options.max_index_bytes = kMaxIndexBytes;
  const Scene& scene = contents.recipe.scene;
  const WrittenIndex all = write_index({scene,
                                        scene_hash_of(scene),
                                        options,
                                        model.subdivision,
                                        model.clusters,
                                        model.sphere_classes,
                                        model.classes,
                                        model.types,
                                        model.symmetries,
                                        {},
                                        packed_model(scene)});
  return {all.bytes.size() + model.index.statistics.index.golden_frame_bytes,
          all.statistics.key_views};
}

std::vector<double> areas_of(const SphereMesh& mesh, std::size_t aspects) {
  std::vector<double> areas(aspects, 0);
  for (const SpherePiece& piece : mesh.pieces)
    if (piece.class_id != kNoClass)
      areas[static_cast<std::size_t>(piece.class_id)] +=
          mesh.area_sr(piece) / (4 * std::numbers::pi);
  return areas;
}

Result<StoreContents> contents_of_store(const std::filesystem::path& file) {
  const Result<Store> store = Store::open_existing(file);
  if (!store) return Error{store.error()};
  return store.value().contents();
}

void look_at_sphere(ReportContents& contents) {
  LearntModel& model = contents.model;
  contents.levels = coverage_by_level(model.subdivision, contents.recipe.options);
  contents.mesh = sphere_mesh(model.subdivision.sphere, model.sphere_classes);
  contents.areas = areas_of(contents.mesh, contents.aspects());
  contents.neighbours = aspect_neighbours(contents.mesh, contents.aspects());
  contents.colours = map_colours(contents.neighbours);
  contents.axes = object_axes(model.symmetries);
}

}  // namespace

std::string contour_letters(std::size_t name) {
  std::array<char, 4> buffer;
  return std::string(contour_name(static_cast<std::uint16_t>(name), buffer));
}

Result<ReportContents> gather(const std::filesystem::path& store, const ReportSettings& settings) {
  std::optional<tbb::global_control> limit;
  if (settings.trials.jobs > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(settings.trials.jobs));
  Result<Recipe> recipe = recipe_of_store(store, settings.scene);
  if (!recipe) return Error{recipe.error()};
  Result<StoreContents> kept = contents_of_store(store);
  if (!kept) return Error{kept.error()};
  CompileOptions options = recipe.value().options;
  options.jobs = settings.trials.jobs;
  Result<LearntModel> model = compile_model(recipe.value().scene, options, store, {}, nullptr);
  if (!model) return Error{model.error()};
  Result<ClassIndex> index =
      parse_index(std::as_bytes(std::span(model.value().index.bytes)), store.string());
  if (!index) return Error{index.error()};
  Result<Explanation> explanation =
      explain(std::move(index).value(), store, recipe.value(), settings.trials);
  if (!explanation) return Error{explanation.error()};
  const Result<Renderer> renderer = Renderer::create(recipe.value().scene);
  if (!renderer) return Error{store.string() + ": " + renderer.error()};

  ReportContents contents{};
  contents.recipe = std::move(recipe).value();
  contents.store = std::move(kept).value();
  std::error_code unknown;
  contents.store_bytes = std::filesystem::file_size(store, unknown);
  contents.model = std::move(model).value();
  contents.explanation = std::move(explanation).value();
  look_at_sphere(contents);
  const Scene& scene = contents.recipe.scene;
  contents.studio = upright(scene.studio);
  // The thesis's objects are Bob scenes; what else has such a name is something else.
  if (lower_extension(scene.file) == ".b") contents.thesis = thesis_rows(scene.name);
  contents.without_budget = without_budget(contents);
  contents.halves = six_halves(contents, renderer.value());
  contents.overview =
      half_towards("", overview_direction(contents.studio.up), contents, renderer.value());
  contents.views = aspect_views(contents.model, scene, renderer.value(), contents.recipe.options,
                                pictures_of_each(contents.aspects()));
  return contents;
}

}  // namespace aspect
