// What a store keeps so that its model can be made again from it alone: the scene and the options.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "compiler/aspects/compile_options.h"
#include "compiler/scene/scene.h"
#include "compiler/store/store.h"

namespace aspect {

struct Recipe {
  Scene scene;
  CompileOptions options;
};

// FNV-1a of the scene's source.
std::uint64_t scene_hash_of(const Scene& scene);

// Of the store that holds this scene's views by these options.
StoreKey store_key_of(const Scene& scene, const CompileOptions& options);

Result<Done> keep_recipe(Store& store, const Scene& scene, const CompileOptions& options);

// The recipe of a store. The scene is read from the text that the store keeps, or where that is not
// all of it, from its file; a scene given here is taken instead. In each case it must be the one
// that the store was made with. Errors name the store.
Result<Recipe> read_recipe(const std::filesystem::path& store,
                           const std::optional<Scene>& scene = std::nullopt);

// The options as text, a line each, `jobs` left out; and back. Unknown names are errors, missing
// ones leave what they are by default.
std::string options_text(const CompileOptions& options);
Result<CompileOptions> parse_options(const std::string& text);

}  // namespace aspect
