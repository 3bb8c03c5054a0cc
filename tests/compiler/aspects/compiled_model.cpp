#include "tests/compiler/aspects/compiled_model.h"

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/scene/bob_reader.h"

namespace aspect {
namespace {

CompiledModel compile_model(const std::string& name, int level) {
  CompiledModel model{model_scene(name), options_of_level(level), {}, {}};
  const Result<Renderer> renderer = Renderer::create(model.scene);
  Result<Subdivision> subdivided =
      subdivide({renderer.value(), model.scene.studio, model.options, nullptr, {}, nullptr});
  model.subdivision = std::move(subdivided).value();
  model.clusters = find_clusters(model.subdivision, model.options);
  return model;
}

}  // namespace

std::filesystem::path model_file(const std::string& name) {
  return ASPECT_SOURCE_DIR "/compiler/models/" + name + ".b";
}

Scene model_scene(const std::string& name) {
  return read_bob(model_file(name)).value();
}

Scene small_model_scene(const std::string& name) {
  Scene scene = model_scene(name);
  scene.studio.width_px = scene.studio.height_px = 128;
  return scene;
}

CompileOptions options_of_level(int level) {
  CompileOptions options;
  options.level = level;
  options.min_level = std::min(options.min_level, level);
  return options;
}

const CompiledModel& compiled_model(const std::string& name, int level) {
  static std::map<std::pair<std::string, int>, CompiledModel> models;
  const auto found = models.find({name, level});
  if (found != models.end()) return found->second;
  return models.emplace(std::pair(name, level), compile_model(name, level)).first->second;
}

std::vector<std::uint8_t> index_bytes_of(const Scene& scene, const CompileOptions& options) {
  return compile(scene, options, std::nullopt, {}, nullptr).value().bytes;
}

std::uint16_t main_surface(const ObservedContour& contour) {
  const auto fewer = [](const SurfaceShare& a, const SurfaceShare& b) {
    return a.pixels < b.pixels;
  };
  return std::max_element(contour.surfaces.begin(), contour.surfaces.end(), fewer)->surface;
}

}  // namespace aspect
