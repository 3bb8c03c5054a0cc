#include "compiler/matching/graph_match.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/compiler/matching/plain_match.h"
#include "tests/compiler/matching/random_views.h"

namespace aspect {
namespace {

constexpr double kStep_rad = std::numbers::pi / 8;  // of the 16-way directions
const MatchLimits kAnyCost{.cost = 1e12};

// Views keep their attributes as floats, which a turn rounds: about 1e-7 / 0.05, squared, is 1e-11
// of a unit, and 1e-3 is far above that and far below every true difference.
constexpr double kNothing = 1e-3;

bool is_permutation_of(const std::vector<std::uint8_t>& mapping, std::size_t count) {
  std::vector<std::uint8_t> sorted = mapping, wanted(count);
  std::sort(sorted.begin(), sorted.end());
  std::iota(wanted.begin(), wanted.end(), std::uint8_t{0});
  return sorted == wanted;
}

struct Pair {
  ObservedView a, b;
};

// From the same view twice to views that have nothing to do with each other.
Pair random_pair(std::mt19937& random, int round) {
  const std::size_t count = 1 + static_cast<std::size_t>(round) % 8;
  const ObservedView a = random_view(random, count);
  const double noise = std::array{0.0, 0.01, 0.1}[static_cast<std::size_t>(round / 7) % 3];
  const bool other = round % 5 == 0;
  return {a, other ? random_view(random, count) : shuffled_view(random, a, noise)};
}

}  // namespace

TEST_CASE("the search finds the cost that trying every mapping finds") {
  std::mt19937 random(1);
  const MatchScales scales;
  for (int round = 0; round < 300; ++round) {
    Pair pair = random_pair(random, round);
    if (round % 4 == 0) pair.b.relations.resize(pair.b.relations.size() / 2);
    const GraphMatch match = match_graphs(pair.a, pair.b, scales, kAnyCost);
    INFO("round " << round);
    REQUIRE(is_permutation_of(match.mapping, pair.a.external_count));
    REQUIRE_FALSE(match.gave_up);
    // The attributes are floats, and turning them rounds them: 1e-7 of their size, not 1e-9.
    const double least = plain_match_cost(pair.a, pair.b, scales);
    CHECK(match.cost == Approx(least).epsilon(2e-6).margin(kNothing));
    CHECK(plain_cost(pair.a, pair.b, scales, match.mapping) ==
          Approx(match.cost).epsilon(2e-6).margin(kNothing));
    CHECK(mapping_cost(pair.a, pair.b, scales, match.mapping) ==
          Approx(match.cost).epsilon(1e-12).margin(1e-9));
  }
}

TEST_CASE("no mapping costs less than the one found, to the ninth digit") {
  std::mt19937 random(2);
  const MatchScales scales;
  for (int round = 0; round < 300; ++round) {
    const Pair pair = random_pair(random, round);
    const GraphMatch match = match_graphs(pair.a, pair.b, scales, kAnyCost);
    std::vector<std::uint8_t> mapping(pair.a.external_count);
    std::iota(mapping.begin(), mapping.end(), std::uint8_t{0});
    double least = kNoMatch;
    do {
      least = std::min(least, mapping_cost(pair.a, pair.b, scales, mapping));
    } while (std::next_permutation(mapping.begin(), mapping.end()));
    INFO("round " << round);
    CHECK(match.cost == Approx(least).epsilon(1e-9).margin(1e-9));
  }
}

TEST_CASE("a view matches itself at no cost") {
  std::mt19937 random(3);
  for (std::size_t count = 1; count <= 20; ++count) {
    const ObservedView view = random_view(random, count);
    const GraphMatch match = match_graphs(view, view, MatchScales{}, {.cost = 0});
    INFO(count << " contours");
    CHECK(match.cost < 1e-9);
    CHECK(is_permutation_of(match.mapping, count));
  }
}

TEST_CASE("two views cost the same in either order, with mappings that undo each other") {
  std::mt19937 random(4);
  const MatchScales scales;
  int unlike = 0;
  for (int round = 0; round < 300; ++round) {
    const Pair pair = random_pair(random, round);
    const GraphMatch there = match_graphs(pair.a, pair.b, scales, kAnyCost);
    const GraphMatch back = match_graphs(pair.b, pair.a, scales, kAnyCost);
    INFO("round " << round);
    CHECK(there.cost == Approx(back.cost).epsilon(2e-6).margin(kNothing));
    // Among equal ones any may be taken, but each must be worth the same in the other direction.
    CHECK(mapping_cost(pair.b, pair.a, scales, reversed(there).mapping) ==
          Approx(there.cost).epsilon(2e-6).margin(kNothing));
    if (reversed(there).mapping != back.mapping) ++unlike;
  }
  CHECK(unlike < 30);
}

TEST_CASE("a roll halfway between two of the sixteen directions is rounded alike both ways") {
  std::mt19937 random(14);
  for (int round = 0; round < 320; ++round) {
    const ObservedView a = random_view(random, 5);
    ObservedView b = random_view(random, 5);
    b.direction = a.direction;
    b.right = rolled_view(a, (round % 16 + 0.5) * kStep_rad).right;
    const double there = match_graphs(a, b, MatchScales{}, kAnyCost).cost;
    CHECK(match_graphs(b, a, MatchScales{}, kAnyCost).cost == Approx(there).epsilon(2e-6));
  }
}

TEST_CASE("giving up prunes the search but changes no result that is accepted") {
  std::mt19937 random(5);
  const MatchScales scales;
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    const Pair pair = random_pair(random, round);
    const GraphMatch free = match_graphs(pair.a, pair.b, scales, kAnyCost);
    for (const double factor : {1.0 + 1e-9, 1.5, 10.0}) {
      const GraphMatch limited =
          match_graphs(pair.a, pair.b, scales, {.cost = free.cost * factor + 1e-9});
      CHECK(limited.mapping == free.mapping);
      CHECK(limited.cost == free.cost);
    }
    if (free.cost < kNothing) continue;
    const GraphMatch none = match_graphs(pair.a, pair.b, scales, {.cost = free.cost * (1 - 1e-9)});
    CHECK(none.cost == kNoMatch);
    CHECK(none.mapping.empty());
    ++refused;
  }
  CHECK(refused > 200);
}

TEST_CASE("reversing a match twice gives the match") {
  std::mt19937 random(6);
  for (int round = 0; round < 300; ++round) {
    const Pair pair = random_pair(random, round);
    const GraphMatch match = match_graphs(pair.a, pair.b, MatchScales{}, kAnyCost);
    const GraphMatch back = reversed(match);
    CHECK(back.cost == match.cost);
    for (std::size_t i = 0; i < match.mapping.size(); ++i)
      CHECK(back.mapping[match.mapping[i]] == i);
    CHECK(reversed(back).mapping == match.mapping);
  }
  const GraphMatch none = reversed(GraphMatch{});
  CHECK(none.mapping.empty());
  CHECK(none.cost == kNoMatch);
}

TEST_CASE("a view turned about the optical axis matches at no cost") {
  std::mt19937 random(7);
  for (int step = 0; step < 16; ++step) {
    for (std::size_t count = 1; count <= 8; ++count) {
      const ObservedView view = random_view(random, count);
      const ObservedView rolled = rolled_view(view, step * kStep_rad);
      INFO(count << " contours, " << step << " steps");
      CHECK(match_graphs(view, rolled, MatchScales{}, kAnyCost).cost < kNothing);
      CHECK(match_graphs(rolled, view, MatchScales{}, kAnyCost).cost < kNothing);
    }
  }
}

TEST_CASE("turns between the sixteen directions cost nothing either") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  for (int round = 0; round < 100; ++round) {
    const ObservedView view = random_view(random, 1 + static_cast<std::size_t>(round) % 8);
    const ObservedView rolled = rolled_view(view, angle(random));
    CHECK(match_graphs(view, rolled, MatchScales{}, kAnyCost).cost < kNothing);
  }
}

TEST_CASE("a picture turned while its camera is not, or the other way about, costs") {
  std::mt19937 random(9);
  for (int round = 0; round < 50; ++round) {
    const ObservedView view = random_view(random, 4);
    ObservedView picture = rolled_view(view, std::numbers::pi / 2);
    ObservedView camera = view;
    camera.right = picture.right;
    picture.right = view.right;
    CHECK(match_graphs(view, picture, MatchScales{}, kAnyCost).cost > 1000);
    CHECK(match_graphs(view, camera, MatchScales{}, kAnyCost).cost > 1000);
  }
}

TEST_CASE("the same picture from elsewhere on the great circle matches at no cost") {
  std::mt19937 random(10);
  for (int round = 0; round < 100; ++round) {
    const ObservedView view = random_view(random, 5);
    const Eigen::Vector3d to = (view.direction + 0.5 * random_unit_vector(random)).normalized();
    const ObservedView carried = carried_view(view, to);
    CHECK(match_graphs(view, carried, MatchScales{}, kAnyCost).cost < kNothing);
    const ObservedView both = carried_view(rolled_view(view, 1 + round), to);
    CHECK(match_graphs(view, both, MatchScales{}, kAnyCost).cost < kNothing);
  }
}

TEST_CASE("views with different numbers of contours, or none, do not match") {
  std::mt19937 random(11);
  const ObservedView three = random_view(random, 3), four = random_view(random, 4);
  const ObservedView none = random_view(random, 0);
  for (const auto& [a, b] : {std::pair(&three, &four), {&four, &three}, {&none, &none}}) {
    const GraphMatch match = match_graphs(*a, *b, MatchScales{}, kAnyCost);
    CHECK(match.cost == kNoMatch);
    CHECK(match.mapping.empty());
    CHECK_FALSE(match.gave_up);
  }
}

TEST_CASE("contours that are no nodes do not count") {
  std::mt19937 random(12);
  const ObservedView view = random_view(random, 3);
  ObservedView with_hole = view;
  with_hole.contours.push_back(random_view(random, 1).contours.front());
  with_hole.contours.back().external = false;
  CHECK(match_graphs(view, with_hole, MatchScales{}, kAnyCost).cost < 1e-9);
  const GraphMatch match = match_graphs(with_hole, view, MatchScales{}, kAnyCost);
  CHECK(match.cost < 1e-9);
  CHECK(match.mapping.size() == 3);
}

TEST_CASE("a search that would take for ever is cut short and says so") {
  std::mt19937 random(13);
  ObservedView view = random_view(random, 24);
  for (ObservedContour& contour : view.contours) contour.feature = view.contours[0].feature;
  ObservedView other = view;
  // No mapping is free, all are alike: nothing can be pruned.
  for (Relation& relation : other.relations)
    relation.direction = static_cast<std::uint8_t>(random() % 16);
  const auto start = std::chrono::steady_clock::now();
  const GraphMatch match = match_graphs(view, other, MatchScales{}, kAnyCost);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
  CHECK(match.gave_up);
  REQUIRE(is_permutation_of(match.mapping, 24));
  CHECK(mapping_cost(view, other, MatchScales{}, match.mapping) == Approx(match.cost));
}

}  // namespace aspect
