#include "tools/aspectc/project/store_recipe.h"

#include "tools/aspectc/project/prepared_object.h"

namespace aspect {

Result<Recipe> recipe_of_store(const std::filesystem::path& store,
                               const std::filesystem::path& scene_file) {
  if (scene_file.empty()) return read_recipe(store);
  const Result<Scene> scene = read_prepared_scene(scene_file);
  if (!scene) return Error{scene.error()};
  return read_recipe(store, scene.value());
}

}  // namespace aspect
