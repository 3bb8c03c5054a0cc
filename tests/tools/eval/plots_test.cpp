// The plots of an evaluation, as another program reads them.
#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"
#include "tests/tools/plot/drawn_svg.h"
#include "tools/eval/confusion_svg.h"
#include "tools/eval/pose_error_svg.h"
#include "tools/eval/rank_svg.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Json = nlohmann::json;

// Whose views have these ranks, and poses that are off by so many degrees, per cent and pixels.
ObjectEvaluation object_of(const std::string& name, const std::vector<int>& ranks) {
  ObjectEvaluation object;
  object.object = name;
  for (const int rank : ranks) {
    ViewOutcome& outcome = object.outcomes.emplace_back();
    outcome.rank = rank;
    outcome.rank_with_symmetry = rank == 0 ? 0 : 1;
    outcome.error_deg = 0.5;
    if (rank > 0) outcome.pose = PoseError{0.1 * rank, 0.01 * rank, 1.0 * rank};
  }
  return object;
}

Evaluation two_objects() {
  Evaluation evaluation;
  evaluation.settings.views = 4;
  evaluation.objects = {object_of("CUBE", {1, 1, 2, 0}), object_of("truck <2>", {1, 3, 3, 11})};
  evaluation.confusion = Confusion{{{3, 1, 0}, {0, 2, 2}}, {}, {}, {}, {}};
  return evaluation;
}

std::string error_of(const std::string& table) {
  const TemporaryFolder folder;
  const auto ranks = read_thesis_ranks(folder.write("ranks.csv", table));
  REQUIRE_FALSE(ranks);
  CHECK(std::count(ranks.error().begin(), ranks.error().end(), '\n') == 0);
  return ranks.error();
}

}  // namespace

TEST_CASE("The rank plot has a line an object and a mark a rank, with and without symmetry") {
  const Evaluation evaluation = two_objects();
  CHECK(percent_within(evaluation.objects[0].outcomes, 1, false) == 50);
  CHECK(percent_within(evaluation.objects[0].outcomes, 2, false) == 75);
  CHECK(percent_within(evaluation.objects[0].outcomes, 10, false) == 75);
  CHECK(percent_within(evaluation.objects[0].outcomes, 1, true) == 75);
  CHECK(percent_within(evaluation.objects[1].outcomes, 10, false) == 75);
  const Json plain = drawn_svg(rank_svg(evaluation, {}));
  CHECK(plain["curves"].size() == 4);
  for (const Json& curve : plain["curves"]) CHECK(curve["points"].size() == 10);
  CHECK(plain["marks"] == 42);  // with the legend's
  CHECK(plain["outside"].empty());
  // 50, 75 and 75 % of the 340 px of the left panel, which ends at 418.
  CHECK(plain["curves"][0]["points"][0] == Json{68, 248});
  CHECK(plain["curves"][0]["points"][1][1] == 163);
  const Json beside = drawn_svg(rank_svg(evaluation, {{"CUBE", {{1, 22}, {10, 94}}}}));
  REQUIRE(beside["curves"].size() == 5);
  CHECK(beside["curves"][0]["dashes"] != "");
  CHECK(beside["curves"][0]["stroke"] == beside["curves"][1]["stroke"]);
  CHECK(beside["curves"][0]["points"][0][1].get<double>() == Approx(418 - 3.4 * 22));
}

TEST_CASE("The error plot has a panel a kind and a line an object, up to the share with a pose") {
  const Json drawn = drawn_svg(pose_error_svg(two_objects()));
  REQUIRE(drawn["curves"].size() == 8);
  CHECK(drawn["outside"].empty());
  CHECK(drawn["marks"] == 10);  // half of all, and the legend's
  // Of the first object one view of four has no pose: the turn's line ends at 75 % of 230 px.
  const Json& turns = drawn["curves"][2]["points"];
  CHECK(turns.back()[1].get<double>() == Approx(56 + 0.25 * 230).margin(0.06));
  for (std::size_t k = 1; k < turns.size(); ++k) {
    CHECK(turns[k][0] >= turns[k - 1][0]);
    CHECK(turns[k][1] <= turns[k - 1][1]);
  }
  ClutterEvaluation clutter;
  clutter.objects.emplace_back().object = "nothing";
  CHECK(drawn_svg(pose_error_svg(clutter))["curves"].empty());
}

TEST_CASE("A million errors are a line of some hundred points") {
  Evaluation evaluation;
  evaluation.objects = {object_of("many", std::vector<int>(100'000, 1))};
  for (std::size_t k = 0; k < evaluation.objects[0].outcomes.size(); ++k)
    evaluation.objects[0].outcomes[k].pose->rotation_deg = 1e-4 * static_cast<double>(k);
  const Json drawn = drawn_svg(pose_error_svg(evaluation));
  for (const Json& curve : drawn["curves"]) CHECK(curve["points"].size() < 1000);
}

TEST_CASE("The heat map has a cell a pair, the darker the more, and says how many") {
  const Json drawn = drawn_svg(confusion_svg(two_objects()));
  std::vector<Json> cells;
  for (const Json& bar : drawn["bars"])
    if (bar["box"][2] == bar["box"][3]) cells.push_back(bar);
  REQUIRE(cells.size() == 6);
  CHECK(drawn["outside"].empty());
  const auto red = [&](std::size_t k) {
    return std::stoi(cells[k]["fill"].get<std::string>().substr(1, 2), nullptr, 16);
  };
  CHECK(red(0) < red(4));
  CHECK(red(4) == red(5));
  CHECK(red(4) < red(1));
  CHECK(red(1) < red(2));
  for (const char* word : {"3", "1", "2", "75.0 %", "50.0 %", "CUBE", "truck <2>", "none"})
    CHECK(std::count(drawn["texts"].begin(), drawn["texts"].end(), word) >= 1);
}

TEST_CASE(
    "The thesis's table is read by its column names, and what is no such table told by line") {
  const TemporaryFolder folder;
  const auto ranks =
      read_thesis_ranks(folder.write("ranks.csv", "level,object,top10,top1\r\n6,TRUCK,95,49\r\n"));
  REQUIRE(ranks);
  const auto* truck = ranks_of(ranks.value(), "truck");
  REQUIRE(truck != nullptr);
  REQUIRE(truck->size() == 2);
  CHECK((*truck)[0].rank == 1);
  CHECK((*truck)[0].percent == 49);
  CHECK(ranks_of(ranks.value(), "cube") == nullptr);
  CHECK_THAT(error_of(""), Contains("ranks.csv:1: names no columns"));
  CHECK_THAT(error_of("object,top1\n"), Contains("has no rows"));
  CHECK_THAT(error_of("object,top1\nA,1\nB\n"), Contains("ranks.csv:3: 1 fields"));
  CHECK_THAT(error_of("object,top1\nA,101\n"), Contains("ranks.csv:2: top1 is not a number"));
  CHECK_THAT(error_of("object,top1\nA,nan\n"), Contains("top1 is not a number"));
  CHECK_FALSE(read_thesis_ranks(folder.path()));
}

}  // namespace aspect
