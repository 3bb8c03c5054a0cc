// Why not the other one, asked of two compiled models seen from anywhere.
#include "tools/replay/rival_explanation.h"

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

RivalExplainer explainer(const char* expected) {
  return {indexes(), {}, find_expected(expected, indexes()).value()};
}

TEST_CASE("The right object was chosen, and another one explains the picture less") {
  RivalExplainer right = explainer("cube"), wrong = explainer("l_shape");
  ModelCamera camera("cube");
  std::mt19937 random(5);
  int laid_over = 0;
  for (int view = 0; view < 12; ++view) {
    const OwnedFrame frame = camera.view(random_direction(random));
    for (RivalExplainer* rival : {&right, &wrong}) {
      rival->make_room(frame.width_px, frame.height_px);
      rival->look(frame.frame());
    }
    const RivalExplanation cube = right.explain(0), other = wrong.explain(0);
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
