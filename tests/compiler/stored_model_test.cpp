// A store's model against the index that the compiler made with the same store.
#include "compiler/stored_model.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "runtime/recognition/class_index.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;

ClassIndex compiled(const Scene& scene, const CompileOptions& options,
                    const std::optional<std::filesystem::path>& store = {}) {
  const Result<CompiledIndex> index = compile(scene, options, store, {}, nullptr);
  REQUIRE(index.ok());
  return parse_index(std::as_bytes(std::span(index.value().bytes)), "test").value();
}

void check_same(const StoredModel& model, const ClassIndex& index) {
  CHECK(model.types == index.types);
  REQUIRE(model.classes.size() == index.classes.size());
  for (std::size_t c = 0; c < index.classes.size(); ++c) {
    CHECK(model.classes[c].view_count == index.classes[c].view_count);
    const auto contours = ClassIndex::part(index.class_contours, index.classes[c].contours);
    REQUIRE(model.classes[c].contours.size() == contours.size());
    for (std::size_t k = 0; k < contours.size(); ++k) {
      const auto& scores = model.classes[c].contours[k].score_of_type;
      const auto known = ClassIndex::part(index.type_scores, contours[k].types);
      REQUIRE(scores.size() == known.size());
      for (const TypeScore& type : known)
        CHECK(scores.at(type.type) == static_cast<double>(type.score));
    }
  }
}

}  // namespace

TEST_CASE("a store's model has the types and classes of its index, and nothing is added") {
  const TemporaryFolder folder;
  const auto store = folder.path() / "l_shape.store";
  CompileOptions options = options_of_level(3);
  options.min_level = 2;
  const Scene scene = small_model_scene("l_shape");
  const ClassIndex index = compiled(scene, options, store);
  const auto views = [&] { return Store::open_existing(store).value().contents().value().views; };
  const std::size_t before = views();
  const Recipe recipe = read_recipe(store).value();
  const StoredModel model = open_stored_model(store, recipe, {}).value();
  check_same(model, index);
  CHECK(model.subdivision.statistics.views_rendered == 0);
  CHECK(model.subdivision.statistics.matches_executed == 0);

  StoredModelSettings lower;
  lower.level = 2;
  options.level = options.min_level = 2;
  options.border_views = 0;
  const StoredModel coarse = open_stored_model(store, recipe, lower).value();
  check_same(coarse, compiled(scene, options));
  CHECK(coarse.subdivision.views.size() == 162);
  CHECK(views() == before);

  lower.level = 4;
  CHECK_THAT(open_stored_model(store, recipe, lower).error(),
             Contains("l_shape.store: its model goes to level 3, not 4"));
}

}  // namespace aspect
