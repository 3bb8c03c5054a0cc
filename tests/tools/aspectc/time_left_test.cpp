#include "tools/aspectc/progress/time_left.h"

#include <catch2/catch.hpp>

#include "tools/aspectc/progress/progress_line.h"

namespace aspect {
namespace {

Progress views(int level, std::size_t done, std::size_t wanted) {
  Progress p;
  p.level = level;
  p.views_done = p.views_total = done;
  p.views_wanted = p.views_of_level = wanted;
  return p;
}

}  // namespace

TEST_CASE("at the last level the views that are left cost what those before have cost") {
  CHECK(seconds_left(views(5, 100, 400), 5, {10, 0}) == Approx(30));
  Progress later = views(5, 100, 400);
  later.views_total = 1000;  // of all levels: cheaper than this level alone would say
  CHECK(seconds_left(later, 5, {10, 0}) == Approx(3));
  CHECK(seconds_left(views(5, 400, 400), 5, {10, 0}) == Approx(0));
}

TEST_CASE("every further level is expected to need twice the views of the one before") {
  CHECK(seconds_left(views(3, 100, 100), 4, {1, 0}) == Approx(2));
  CHECK(seconds_left(views(3, 100, 100), 6, {1, 0}) == Approx(2 + 4 + 8));
  // What came from a store counts for the next level, but not for this one.
  Progress resumed = views(4, 10, 30);
  resumed.views_of_level = 130;
  CHECK(seconds_left(resumed, 5, {1, 0}) == Approx(2 + 26));
}

TEST_CASE("matches of this level are extrapolated from those made") {
  Progress p = views(5, 400, 400);
  p.matches_wanted = 1000;
  CHECK_FALSE(seconds_left(p, 5, {10, 0}).has_value());
  p.matches_done = 250;
  CHECK(seconds_left(p, 5, {10, 2}) == Approx(6));
  p.level = 4;
  CHECK(seconds_left(p, 5, {10, 2}) == Approx(6 + 800 * 10.0 / 400));
}

TEST_CASE("nothing is told before there is anything to tell it from") {
  CHECK_FALSE(seconds_left(views(3, 0, 642), 5, {0, 0}).has_value());
  // All from a store, and there may be more to come.
  Progress known = views(3, 0, 0);
  known.views_of_level = 642;
  CHECK_FALSE(seconds_left(known, 5, {1, 0}).has_value());
  CHECK(seconds_left(known, 3, {1, 0}) == Approx(0));
}

TEST_CASE("the text says level, views, area, time left, and clusters once they are known") {
  Progress p = views(4, 320, 642);
  p.area_accepted = 0.8314;
  CHECK(progress_text("part", 5, p, 12.4) ==
        "part level 4/5, 320 of 642 views, 83.1 % covered, 12 s left");
  CHECK(progress_text("part", 5, p, {}) == "part level 4/5, 320 of 642 views, 83.1 % covered");
  CHECK(progress_text("part", 5, p, 600).ends_with(", 10 min left"));
  CHECK(progress_text("part", 5, p, 7500).ends_with(", 2 h 5 min left"));
  p.views_of_level = 1000;  // 358 of them from a store
  CHECK(progress_text("part", 5, p, {}) == "part level 4/5, 678 of 1000 views, 83.1 % covered");
  p.matches_done = 7;
  p.matches_wanted = 50;
  CHECK(progress_text("part", 5, p, 3).ends_with("covered, 7 of 50 matches, 3 s left"));
  p.clusters = 61;
  CHECK(progress_text("part", 5, p, 0).ends_with("covered, 61 clusters, writing the index"));
}

TEST_CASE("a text is cut between characters and holds nothing that moves a terminal's cursor") {
  CHECK(cut_to_width("part level", 4) == "part");
  CHECK(cut_to_width("part", 10) == "part");
  CHECK(cut_to_width("d\u00f6se", 2) == "d\u00f6");
  CHECK(cut_to_width("d\u00f6se", 1) == "d");
  CHECK(cut_to_width("a\033[2J\nb\x7f", 20) == "a?[2J?b?");
  CHECK(cut_to_width("", 0).empty());
}

}  // namespace aspect
