#include "tools/eval/evaluation.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "tests/temporary_folder.h"
#include "tools/eval/evaluation_json.h"
#include "tools/eval/evaluation_text.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
const std::string kScenes = ASPECT_SOURCE_DIR "/tests/data/rendered/";

// Made at the first call, then kept for the other tests.
const std::vector<std::uint8_t>& index_bytes(const std::string& name) {
  static std::map<std::string, std::vector<std::uint8_t>> kept;
  const auto found = kept.find(name);
  if (found != kept.end()) return found->second;
  const Result<Scene> scene = read_bob(kScenes + name + ".b");
  REQUIRE(scene.ok());
  CompileOptions options;
  options.level = 3;
  Result<CompiledIndex> index = compile(scene.value(), options, {}, {}, nullptr);
  REQUIRE(index.ok());
  return kept[name] = index.value().bytes;
}

EvaluatedObject compiled(const std::string& name, const TemporaryFolder& folder) {
  const std::vector<std::uint8_t>& bytes = index_bytes(name);
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

ViewOutcome with_pose(double rotation_deg, double translation_percent, double reprojection_px) {
  ViewOutcome outcome;
  outcome.pose = PoseError{rotation_deg, translation_percent, reprojection_px};
  return outcome;
}

TEST_CASE("Errors of poses are of the views that have one, what is within 5 is of all") {
  std::vector<ViewOutcome> outcomes = {with_pose(1, 10, 5), with_pose(3, 20, 5.1),
                                       with_pose(11, 30, 5.2)};
  outcomes.emplace_back();
  const auto summary = summarise_poses(outcomes);
  REQUIRE(summary);
  CHECK(summary->found_share == Approx(0.75));
  CHECK(summary->rotation_deg.median == Approx(3));
  CHECK(summary->rotation_deg.p90 == Approx(3 + 0.8 * 8));
  CHECK(summary->rotation_deg.within_5 == Approx(0.5));
  CHECK(summary->translation_percent.median == Approx(20));
  CHECK(summary->translation_percent.within_5 == 0);
  CHECK(summary->reprojection_px.within_5 == Approx(0.25));
  CHECK_FALSE(summarise_poses(std::vector<ViewOutcome>(2)));
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
  int first = 0, first_with_symmetry = 0, within_20 = 0, turned_within_5 = 0;
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
    REQUIRE(outcome.pose);
    // The view is where the camera is: off by the turn and by how far to the side the object is.
    const double aside_deg =
        std::asin(std::min(1.0, outcome.pose->translation_percent / 100)) * 180 / std::numbers::pi;
    CHECK(outcome.error_deg <= outcome.pose->rotation_deg + aside_deg + 0.001);
    turned_within_5 += outcome.pose->rotation_deg <= 5 ? 1 : 0;
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
  // Several times what refined poses of noiseless pictures are off, and far below a key view.
  REQUIRE(evaluation.pose);
  CHECK(evaluation.pose->rotation_deg.within_5 == Approx(turned_within_5 / 60.0));
  CHECK(evaluation.pose->rotation_deg.median < 1);
  CHECK(evaluation.pose->translation_percent.median < 1);
  CHECK(evaluation.pose->reprojection_px.median < 2);
  CHECK(evaluation.reliability.judged() == 60);
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
  // The thesis's ranking looks for no poses.
  CHECK_FALSE(one.pose);
  CHECK(one.reliability.not_judged == 20);
  CHECK(one.reliability.judged() == 0);
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
    const Reliability& reliability = evaluation.confusion->reliability[truth];
    CHECK(reliability.judged() + reliability.not_judged == 30);
    std::size_t right = 0;
    for (const ReliabilityBin& bin : reliability.bins)
      right +=
          static_cast<std::size_t>(std::lround(bin.right_share * static_cast<double>(bin.count)));
    CHECK(right == static_cast<std::size_t>(counts[truth]));
  }
  const Reliability& total = overall_reliability(evaluation);
  CHECK(total.judged() + total.not_judged == 60);

  const auto json = nlohmann::json::parse(evaluation_json(evaluation));
  CHECK(json["objects"][1]["object"] == "l_shape");
  CHECK(json["objects"][1]["views"].size() == 30);
  CHECK(json["objects"][0]["percent_right"]["10"] >= json["objects"][0]["percent_right"]["1"]);
  CHECK(json["confusion"][0]["found"]["cube"] == evaluation.confusion->counts[0][0]);
  CHECK(json["objects"][0]["pose"]["rotation_deg"]["median"] ==
        evaluation.objects[0].pose->rotation_deg.median);
  CHECK(json["objects"][0]["pose"]["translation_percent"]["p90"] ==
        evaluation.objects[0].pose->translation_percent.p90);
  CHECK(json["objects"][0]["pose"]["reprojection_px"]["within_5"] ==
        evaluation.objects[0].pose->reprojection_px.within_5);
  CHECK(json["objects"][0]["views"][3]["pose_error"]["rotation_deg"] ==
        evaluation.objects[0].outcomes[3].pose->rotation_deg);
  CHECK(json["reliability"]["match"] == total.matches);
  CHECK(json["reliability"]["expected_calibration_error"] == *total.expected_calibration_error());
  CHECK(json["reliability"]["bins"].size() == 10);
  CHECK(json["confusion"][1]["reliability"]["match"] ==
        evaluation.confusion->reliability[1].matches);
  const std::string text = evaluation_text(evaluation);
  for (const char* part : {"30 random views", "l_shape", "with symmetry", "best hypothesis's pose",
                           "matches right %", "All indexes at once", "(all)"})
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
