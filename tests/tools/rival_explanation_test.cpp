// Why not the other one, asked of two compiled models seen from anywhere.
#include "tools/replay/rival_explanation.h"

#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {
namespace {

const std::vector<ClassIndex>& indexes() {
  static const std::vector<ClassIndex> both = {model_index("cube", 3), model_index("l_shape", 3)};
  return both;
}

ExpectedHypothesis expected(const char* name) {
  return find_expected(name, indexes()).value();
}

TEST_CASE("The right object was chosen, and another one explains the picture less") {
  RivalExplainer explainer(indexes(), {});
  ModelCamera camera("cube");
  std::mt19937 random(5);
  int laid_over = 0;
  for (int view = 0; view < 12; ++view) {
    const OwnedFrame frame = camera.view(random_direction(random));
    explainer.make_room(frame.width_px, frame.height_px);
    explainer.look(frame.frame());
    const RivalExplanation cube = explainer.explain(0, expected("cube")),
                           other = explainer.explain(0, expected("l_shape"));
    CHECK(cube.chosen);
    CHECK(cube.rank == 1);
    REQUIRE(cube.agreement);
    CHECK(*cube.agreement > 0.95F);
    REQUIRE(cube.least_cost);

    CHECK_FALSE(other.chosen);
    CHECK_FALSE(other.reason.empty());
    REQUIRE(other.hypothesis);
    CHECK(other.on_shortlist == (other.rank > 1));
    REQUIRE(other.least_cost);
    CHECK(*other.least_cost > *cube.least_cost);
    REQUIRE(other.agreement);
    CHECK(*other.agreement < *cube.agreement);
    CHECK_FALSE((other.seen.missing.empty() && other.seen.contradicting.empty()));
    ++laid_over;
  }
  CHECK(laid_over > 0);
}

TEST_CASE("What fills the picture was compared with nothing, and that is said") {
  // Stripes of the colours that the objects have, from border to border.
  OwnedFrame frame{320, 240, {}};
  const std::array<std::array<std::uint8_t, 3>, 4> colours = {
      {{217, 26, 26}, {26, 191, 38}, {31, 51, 217}, {230, 217, 20}}};
  for (int y = 0; y < frame.height_px; ++y)
    for (int x = 0; x < frame.width_px; ++x)
      for (const std::uint8_t level : colours[static_cast<std::size_t>(x / 80)])
        frame.rgb.push_back(level);
  RivalExplainer explainer(indexes(), {});
  explainer.make_room(frame.width_px, frame.height_px);
  explainer.look(frame.frame());
  REQUIRE(explainer.has_seen(0, {0, 0, frame.width_px, frame.height_px}));
  for (const char* name : {"cube", "l_shape"}) {
    const RivalExplanation other = explainer.explain(0, expected(name));
    CHECK_THAT(other.reason, Catch::Matchers::Contains("fills the picture"));
    CHECK(other.needed == 0);
    CHECK_FALSE(other.on_shortlist);
  }
}

TEST_CASE("A class can be expected by its number, of any object or of one") {
  const ExpectedHypothesis any = find_expected("3", indexes()).value(),
                           one = find_expected("l_shape:3", indexes()).value();
  Hypothesis hypothesis;
  hypothesis.class_id = 3;
  CHECK(any.is(hypothesis));
  CHECK_FALSE(one.is(hypothesis));
  hypothesis.index = 1;
  CHECK(any.is(hypothesis));
  CHECK(one.is(hypothesis));
  hypothesis.class_id = 4;
  CHECK_FALSE(any.is(hypothesis));
  CHECK_FALSE(one.is(hypothesis));

  // An object's name goes before numbers and colons.
  std::vector<ClassIndex> named = indexes();
  named[0].object = "3";
  named[1].object = "a:1";
  CHECK_FALSE(find_expected("3", named).value().class_id);
  CHECK_FALSE(find_expected("a:1", named).value().class_id);
  CHECK(find_expected("a:1:2", named).value().class_id == std::uint16_t{2});
}

}  // namespace
}  // namespace aspect
