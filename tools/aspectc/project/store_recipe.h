// The recipe of a store, for programs that let people name its scene anew.
#pragma once

#include <filesystem>

#include "compiler/recipe.h"

namespace aspect {

// As read_recipe(), with the scene or project in this file where it is not empty.
Result<Recipe> recipe_of_store(const std::filesystem::path& store,
                               const std::filesystem::path& scene_file);

}  // namespace aspect
