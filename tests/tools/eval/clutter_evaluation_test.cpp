#include "tools/eval/clutter_evaluation.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "tests/tools/plot/drawn_svg.h"
#include "tools/eval/clutter_report.h"
#include "tools/eval/recall_svg.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

ClutterOutcome seen(double visible, bool found, std::size_t falsely_named = 0) {
  ClutterOutcome outcome;
  outcome.has_object = true;
  outcome.visible = visible;
  outcome.found = found;
  outcome.falsely_named = falsely_named;
  outcome.elapsed_ms = 2;
  return outcome;
}

ClutterOutcome empty(std::size_t falsely_named) {
  ClutterOutcome outcome;
  outcome.falsely_named = falsely_named;
  outcome.elapsed_ms = 4;
  return outcome;
}

ObjectClutter summed() {
  ObjectClutter clutter;
  clutter.object = "part <1>";
  clutter.outcomes = {seen(1, true),     seen(0.95, true), seen(0.85, true),
                      seen(0.75, false), seen(0.6, true),  seen(0.45, false, 1),
                      seen(0.3, false),  empty(2),         empty(0)};
  clutter.outcomes[0].pose = PoseError{1, 2, 3};
  clutter.outcomes[1].pose = PoseError{3, 4, 5};
  summarise(clutter);
  return clutter;
}

// Compiled at the first call, in small pictures.
const EvaluatedObject& small_cube() {
  static const EvaluatedObject object = [] {
    Scene scene = read_bob(ASPECT_SOURCE_DIR "/tests/data/rendered/cube.b").value();
    scene.studio.width_px = scene.studio.height_px = 200;
    CompileOptions options;
    options.level = options.min_level = 1;
    options.border_views = 0;
    const CompiledIndex compiled = compile(scene, options, {}, {}, nullptr).value();
    return EvaluatedObject::of(
               parse_index(std::as_bytes(std::span(compiled.bytes)), "cube").value(), "cube", scene)
        .value();
  }();
  return object;
}

}  // namespace

TEST_CASE("The recall is of frames in which enough is visible, and by share hidden of all") {
  const ObjectClutter clutter = summed();
  CHECK(clutter.with_object == 7);
  CHECK(clutter.empty == 2);
  CHECK(clutter.recall.frames == 4);
  CHECK(clutter.recall.found == 3);
  const std::array<std::array<std::size_t, 2>, 4> expected = {{{2, 2}, {2, 1}, {1, 1}, {2, 0}}};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    CHECK(clutter.by_hidden[k].frames == expected[k][0]);
    CHECK(clutter.by_hidden[k].found == expected[k][1]);
  }
  CHECK(clutter.falsely_named == 3);
  CHECK(clutter.falsely_named_in_empty == 2);
  REQUIRE(clutter.pose);
  CHECK(clutter.pose->rotation_deg.median == 2);
  CHECK(clutter.pose->found_share == 0.5);
  CHECK(clutter.median_ms == 2);
  CHECK(clutter.mean_ms == Approx(22.0 / 9));
}

TEST_CASE("The sums are printed in tables, as JSON and as a plot") {
  ClutterEvaluation evaluation;
  evaluation.settings.views = 9;
  evaluation.hidden_max = 0.7;
  evaluation.objects = {summed()};
  const std::string text = clutter_text(evaluation);
  CHECK_THAT(text, Contains("9 frames in clutter an object") && Contains("75.0") &&
                       Contains("50.0 (2)") && Contains("0.333") && Contains("1.000"));
  const auto json = nlohmann::json::parse(clutter_json(evaluation));
  const auto& clutter = json.at("objects").at(0).at("clutter");
  CHECK(clutter.at("recall").at("percent") == 75);
  CHECK(clutter.at("recall_by_hidden").at(1).at("found") == 1);
  CHECK(clutter.at("recall_by_hidden").at(1).at("hidden_to") == 0.3);
  CHECK(clutter.at("frames").size() == 9);
  CHECK(json.at("backgrounds").is_null());
  const auto drawn = drawn_svg(recall_svg(evaluation));
  CHECK(drawn["outside"].empty());
  // In the middle of 10 to 30 of 70 %, half the way up, of 440 and 380 px from 80, 440.
  REQUIRE(drawn["curves"].size() == 1);
  CHECK(drawn["curves"][0]["points"][1][0].get<double>() ==
        Approx(80 + 440 * 2 / 7.0).margin(0.06));
  CHECK(drawn["curves"][0]["points"][1][1] == 250);
  CHECK(drawn["marks"] == 5);
  CHECK(std::count(drawn["texts"].begin(), drawn["texts"].end(), "part <1>") == 1);
}

TEST_CASE("A cube is found where it is, with any number of threads") {
  const EvaluatedObject& cube = small_cube();
  EvaluationSettings settings;
  settings.views = 12;
  const auto evaluated = [&](std::size_t threads, std::vector<std::vector<std::uint8_t>>& frames) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto clutter = evaluate_clutter({&cube, 1}, 0, settings, {0, {}},
                                          [&](std::size_t number, const ClutteredFrame& frame) {
                                            CHECK(number == frames.size());
                                            CHECK(frame.has_object == (number % 4 != 3));
                                            frames.push_back(frame.rgb);
                                            return std::optional<Error>();
                                          });
    REQUIRE(clutter.ok());
    return clutter.value();
  };
  std::vector<std::vector<std::uint8_t>> frames, again;
  const ObjectClutter one = evaluated(1, frames), four = evaluated(4, again);
  CHECK(frames == again);
  CHECK(one.recall.frames == 9);
  // Nothing is hidden: missed are at most views of one face alone.
  CHECK(one.recall.found >= 6);
  REQUIRE(one.pose);
  CHECK(one.pose->rotation_deg.median < 3);
  CHECK(one.pose->translation_percent.median < 3);
  CHECK(one.recall.found == four.recall.found);
  for (std::size_t k = 0; k < one.outcomes.size(); ++k) {
    CHECK(one.outcomes[k].visible == four.outcomes[k].visible);
    CHECK(one.outcomes[k].pose.has_value() == four.outcomes[k].pose.has_value());
    if (one.outcomes[k].pose)
      CHECK(one.outcomes[k].pose->rotation_deg == four.outcomes[k].pose->rotation_deg);
  }
}

TEST_CASE("Whoever takes the frames can end the evaluation") {
  const auto clutter = evaluate_clutter(
      {&small_cube(), 1}, 0, {}, {},
      [](std::size_t, const ClutteredFrame&) { return std::optional(Error{"the disk is full"}); });
  REQUIRE_FALSE(clutter.ok());
  CHECK(clutter.error() == "the disk is full");
}

TEST_CASE("Clutter is made for cameras of colours in perspective alone") {
  EvaluatedObject object =
      EvaluatedObject::of(small_cube().index, "cube.aspect", small_cube().scene).value();
  CHECK_FALSE(clutter_fault(object));
  object.scene.studio.projection = Projection::kOrthogonal;
  CHECK(clutter_fault(object));
  object.scene.studio.projection = Projection::kPerspective;
  object.index.vision.sensor = SensorKind::grey;
  REQUIRE(clutter_fault(object));
  CHECK_THAT(clutter_fault(object)->message, Catch::Matchers::StartsWith("cube.aspect: "));
}

}  // namespace aspect
