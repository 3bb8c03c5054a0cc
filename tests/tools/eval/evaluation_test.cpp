#include "tools/eval/evaluation.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "tests/temporary_folder.h"
#include "tools/eval/evaluation_json.h"
#include "tools/eval/evaluation_text.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
const std::string kScenes = ASPECT_SOURCE_DIR "/tests/data/rendered/";

EvaluatedObject compiled(const std::string& name, const TemporaryFolder& folder) {
  const Result<Scene> scene = read_bob(kScenes + name + ".b");
  REQUIRE(scene.ok());
  CompileOptions options;
  options.level = 3;
  Result<CompiledIndex> index = compile(scene.value(), options, {}, {}, nullptr);
  REQUIRE(index.ok());
  const std::vector<std::uint8_t>& bytes = index.value().bytes;
  const fs::path file =
      folder.write(name + ".aspect", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  Result<EvaluatedObject> object = EvaluatedObject::load(file, kScenes + name + ".b");
  REQUIRE(object.ok());
  return std::move(object).value();
}

TEST_CASE("Percentiles are interpolated") {
  CHECK(percentile({}, 0.5) == 0);
  CHECK(percentile({7}, 0.9) == 7);
  CHECK(percentile({4, 1, 2, 3}, 0.5) == 2.5);
  CHECK(percentile({0, 10, 20, 30, 40}, 0.9) == Approx(36));
  CHECK(percentile({5, 1}, 1) == 5);
}

TEST_CASE("The experiment tells of every view, and its sums are of these") {
  const TemporaryFolder folder;
  const EvaluatedObject object = compiled("blockcyl1", folder);
  const EvaluationSettings settings{60, 4, Matching::weighted,
                                    RecogniserParameters::Ranking::views};
  const ObjectEvaluation evaluation = evaluate_object(object, settings);
  CHECK(evaluation.object == "blockcyl1");
  CHECK(evaluation.rotations == 2);
  REQUIRE(evaluation.outcomes.size() == 60);
  int first = 0, first_with_symmetry = 0, within_20 = 0;
  for (const ViewOutcome& outcome : evaluation.outcomes) {
    CHECK(outcome.right_class == object.views.right(outcome.direction));
    CHECK(outcome.rank >= 0);
    CHECK(outcome.rank <= kMaxHypotheses);
    // Whoever is right without the symmetry is so with it.
    if (outcome.rank > 0) {
      CHECK(outcome.rank_with_symmetry > 0);
      CHECK(outcome.rank_with_symmetry <= outcome.rank);
    }
    CHECK(outcome.elapsed_ms > 0);
    first += outcome.rank == 1 ? 1 : 0;
    first_with_symmetry += outcome.rank_with_symmetry == 1 ? 1 : 0;
    within_20 += outcome.error_deg <= 20 ? 1 : 0;
  }
  CHECK(evaluation.right[0] == Approx(first / 60.0));
  CHECK(evaluation.right_with_symmetry[0] == Approx(first_with_symmetry / 60.0));
  CHECK(evaluation.error.within_20 == Approx(within_20 / 60.0));
  CHECK(std::is_sorted(evaluation.right.begin(), evaluation.right.end()));
  // The object looks the same after half a turn: the right class can only be guessed without.
  CHECK(evaluation.right[0] < 0.8);
  CHECK(evaluation.right_with_symmetry[0] > evaluation.right[0]);
  CHECK(evaluation.right_with_symmetry[4] > 0.9);
  CHECK(evaluation.error.median_deg < 10);
}

TEST_CASE("The same settings give the same ranks") {
  const TemporaryFolder folder;
  const EvaluatedObject object = compiled("cube", folder);
  const EvaluationSettings settings{20, 9, Matching::simple,
                                    RecogniserParameters::Ranking::classes};
  const ObjectEvaluation one = evaluate_object(object, settings);
  const ObjectEvaluation two = evaluate_object(object, settings);
  for (std::size_t k = 0; k < one.outcomes.size(); ++k) {
    CHECK(one.outcomes[k].rank == two.outcomes[k].rank);
    CHECK(one.outcomes[k].error_deg == two.outcomes[k].error_deg);
  }
}

TEST_CASE("With several objects each view is counted once in the confusion table") {
  const TemporaryFolder folder;
  std::vector<EvaluatedObject> objects;
  objects.push_back(compiled("cube", folder));
  objects.push_back(compiled("l_shape", folder));
  Evaluation evaluation;
  evaluation.settings.views = 30;
  for (const EvaluatedObject& object : objects)
    evaluation.objects.push_back(evaluate_object(object, evaluation.settings));
  evaluation.confusion = evaluate_confusion(objects, evaluation.settings);
  for (std::size_t truth = 0; truth < 2; ++truth) {
    const std::vector<int>& counts = evaluation.confusion->counts[truth];
    REQUIRE(counts.size() == 3);
    CHECK(counts[0] + counts[1] + counts[2] == 30);
    CHECK(counts[truth] >= 27);
  }

  const auto json = nlohmann::json::parse(evaluation_json(evaluation));
  CHECK(json["objects"][1]["object"] == "l_shape");
  CHECK(json["objects"][1]["views"].size() == 30);
  CHECK(json["objects"][0]["percent_right"]["10"] >= json["objects"][0]["percent_right"]["1"]);
  CHECK(json["confusion"][0]["found"]["cube"] == evaluation.confusion->counts[0][0]);
  const std::string text = evaluation_text(evaluation);
  for (const char* part : {"30 random views", "l_shape", "with symmetry", "All indexes at once"})
    CHECK_THAT(text, Catch::Matchers::Contains(part));
}

TEST_CASE("Files that are no good are named") {
  const TemporaryFolder folder;
  const auto error_of = [](const fs::path& index, const fs::path& scene) {
    const Result<EvaluatedObject> object = EvaluatedObject::load(index, scene);
    REQUIRE_FALSE(object.ok());
    return object.error();
  };
  const fs::path no_index = folder.write("no.aspect", "text");
  CHECK_THAT(error_of(no_index, "cube.b"), Catch::Matchers::StartsWith(no_index.native()));
  static_cast<void>(compiled("cube", folder));
  CHECK_THAT(error_of(folder.path() / "cube.aspect", "none.b"),
             Catch::Matchers::StartsWith("none.b"));
}

}  // namespace
}  // namespace aspect
