#include "tools/eval/reliability.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "tests/tools/plot/drawn_svg.h"
#include "tools/eval/reliability_svg.h"

namespace aspect {
namespace {

using Json = nlohmann::json;

}  // namespace

TEST_CASE("Verdicts are counted, and the matches that are right") {
  const std::array views = {
      JudgedView{Verdict::match, 0.9, true},      JudgedView{Verdict::match, 0.8, false},
      JudgedView{Verdict::match, 0.7, true},      JudgedView{Verdict::match, 0.6, true},
      JudgedView{Verdict::ambiguous, 0.5, false}, JudgedView{Verdict::unknown, 0.2, true},
      JudgedView{Verdict::unknown, 0.1, false},   JudgedView{}};
  const Reliability reliability = reliability_of(views);
  CHECK(reliability.matches == 4);
  CHECK(reliability.ambiguous == 1);
  CHECK(reliability.unknown == 2);
  CHECK(reliability.not_judged == 1);
  CHECK(reliability.judged() == 7);
  CHECK(reliability.right_match_share() == Approx(0.75));
}

TEST_CASE("The calibration error is the bins' distances weighted by their views") {
  const std::array views = {
      JudgedView{Verdict::match, 0.95, true},     JudgedView{Verdict::match, 1, false},
      JudgedView{Verdict::match, 0.85, true},     JudgedView{Verdict::match, 0.85, false},
      JudgedView{Verdict::ambiguous, 0.62, true}, JudgedView{Verdict::unknown, 0.15, false},
      JudgedView{Verdict::none, 0, false}};
  const Reliability reliability = reliability_of(views);
  CHECK(reliability.bins[9].count == 2);
  CHECK(reliability.bins[9].mean_probability == Approx(0.975));
  CHECK(reliability.bins[9].right_share == Approx(0.5));
  CHECK(reliability.bins[0].count == 0);
  // 2 |0.975 - 0.5| + 2 |0.85 - 0.5| + |0.62 - 1| + |0.15 - 0|, of six views
  CHECK(reliability.expected_calibration_error() == Approx(2.18 / 6));
}

TEST_CASE("Right as often as believed is no calibration error, with other views in the bin") {
  std::array<JudgedView, 20> views;
  for (std::size_t k = 0; k < views.size(); ++k)
    views[k] = {Verdict::match, k % 2 == 0 ? 0.72 : 0.78, k < 15};
  CHECK(reliability_of(views).expected_calibration_error() == Approx(0).margin(1e-12));
}

TEST_CASE("A bin holds its lower bound, the last one certainty as well") {
  for (const auto& [probability, bin] :
       {std::pair{0.0, 0U}, {0.0999, 0U}, {0.5, 5U}, {0.4999, 4U}, {0.9, 9U}, {1.0, 9U}}) {
    CAPTURE(probability);
    const std::array views = {JudgedView{Verdict::unknown, probability, false}};
    CHECK(reliability_of(views).bins[bin].count == 1);
  }
}

TEST_CASE("Of nothing there are no shares") {
  const std::array views = {JudgedView{}};
  CHECK_FALSE(reliability_of(views).right_match_share());
  CHECK_FALSE(reliability_of(views).expected_calibration_error());
  CHECK_FALSE(reliability_of({}).expected_calibration_error());
}

TEST_CASE("The plot has a point for each bin with views, its number over it, and the diagonal") {
  // 400 px a side from 80, 76: 0.2 of it is at 160, 0.75 up from the bottom at 176.
  std::array<JudgedView, 5> views;
  views.fill({Verdict::unknown, 0.2, true});
  views[3].right = false;
  views[4] = {Verdict::match, 1, true};
  const Json drawn = drawn_svg(reliability_svg(reliability_of(views)));
  CHECK(drawn["circles"] == Json{{160, 176}, {480, 76}});
  CHECK(drawn["outside"].empty());
  CHECK(std::count(drawn["lines"].begin(), drawn["lines"].end(), Json{{80, 476}, {480, 76}}) == 1);
  // 4 |0.2 - 0.75| of five views
  for (const char* word : {"4", "1", "5 views judged, expected calibration error 0.440"})
    CHECK(std::count(drawn["texts"].begin(), drawn["texts"].end(), word) >= 1);
}

TEST_CASE("A plot of nothing says so and has no points") {
  const std::string svg = reliability_svg({});
  CHECK_THAT(svg, Catch::Contains("No view was judged"));
  CHECK(drawn_svg(svg)["circles"].empty());
}

}  // namespace aspect
