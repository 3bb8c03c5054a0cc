// A store's recipe: the scene and the options that its model was made with.
#include "compiler/recipe.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;

constexpr const char* kScene = R"(
studio { at 0 0 0 up 0 0 1 angle 50 resolution 96 96 antialias none aspect 1 ambient 1 1 1 }
#define RED .8 .1 .1
surface { diffuse RED }
polygon { points 4 vertex -.2 -.2 .2 vertex .2 -.2 .2 vertex .2 .2 .2 vertex -.2 .2 .2 }
surface { diffuse .1 .8 .1 } // the other side
polygon { points 4 vertex .2 -.2 -.2 vertex .2 .2 -.2 vertex .2 .2 .2 vertex .2 -.2 .2 }
)";

CompileOptions odd_options() {
  CompileOptions options = options_of_level(2);
  options.cluster_threshold = 123456.78901234567;
  options.scoring = Scoring::area;
  options.vision.smooth = false;
  options.vision.thickness_min_px = 3.3F;
  options.match_scales.second = 1.0 / 3;
  return options;
}

void compile_to(const Scene& scene, const std::filesystem::path& store) {
  REQUIRE(compile(scene, odd_options(), store, {}, nullptr).ok());
}

}  // namespace

TEST_CASE("options become text and the same options again") {
  const CompileOptions options = odd_options();
  const CompileOptions again = parse_options(options_text(options)).value();
  CHECK(options_text(again) == options_text(options));
  CHECK(again.store_key() == options.store_key());
  CHECK(again.scoring == Scoring::area);
  CHECK(again.level == 2);
  CHECK(again.cluster_threshold == options.cluster_threshold);
  CHECK_THAT(parse_options("levels 3").error(), Contains("levels"));
  CHECK_THAT(parse_options("level many").error(), Contains("level"));
  for (const char* text : {"level 99", "threshold -1", "contour_types 0", "threshold nan",
                           "max_index_bytes 99999999999", "scoring 7"})
    CHECK_FALSE(parse_options(text).ok());
}

TEST_CASE("the thesis's models are read again from what a store keeps of them") {
  for (const char* name : {"cube", "l_shape", "truck", "blockcyl3", "dumbbell", "holeblock"}) {
    CAPTURE(name);
    const Scene scene = model_scene(name);
    const Result<Scene> again = parse_bob(scene.source, scene.file);
    REQUIRE(again.ok());
    CHECK(again.value().source == scene.source);
    CHECK(again.value().primitives.size() == scene.primitives.size());
  }
}

TEST_CASE("a store makes its model again when the scene's file is gone") {
  const TemporaryFolder folder;
  const auto file = folder.write("part.b", kScene);
  const Scene scene = read_bob(file).value();
  const auto store = folder.path() / "part.store";
  compile_to(scene, store);
  std::filesystem::remove(file);
  const Recipe recipe = read_recipe(store).value();
  CHECK(recipe.scene.name == "part");
  CHECK(recipe.scene.primitives.size() == 2);
  const auto first = compile(scene, odd_options(), {}, {}, nullptr).value();
  const auto again = compile(recipe.scene, recipe.options, store, {}, nullptr).value();
  CHECK(again.bytes == first.bytes);
  CHECK(again.statistics.subdivision.views_rendered == 0);
}

TEST_CASE("a store that is missing, foreign, unfinished or of another scene is refused") {
  const TemporaryFolder folder;
  CHECK_THAT(read_recipe(folder.path() / "none.store").error(), Contains("none.store"));
  CHECK_THAT(read_recipe(folder.write("text.store", "no store")).error(), Contains("text.store"));
  const auto store = folder.path() / "part.store";
  const Scene scene = read_bob(folder.write("part.b", kScene)).value();
  { REQUIRE(Store::open(store, {"0", odd_options().store_key(), "0", "part"}).ok()); }
  CHECK_THAT(read_recipe(store).error(), Contains("not complete"));
  {
    Store old = Store::open_existing(store).value();
    REQUIRE(old.add_finished_run({}).ok());
  }
  CHECK_THAT(read_recipe(store).error(), Contains("does not say how it was made"));
  std::filesystem::remove(store);
  compile_to(scene, store);
  CHECK_THAT(read_recipe(store, model_scene("cube")).error(), Contains("another scene"));
  CHECK(read_recipe(store, scene).ok());
}

}  // namespace aspect
