#include "runtime/recognition/class_match.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "tests/rounds.h"
#include "tests/runtime/recognition/made_index.h"

namespace aspect {
namespace {

// class_1 of the thesis (3.4) with the weights of (3.6).
const MadeClass kThesisClass = {{{4, 0.5F}, {9, 0.1F}, {11, 0.1F}},
                                {{17, 0.3F}, {20, 0.1F}, {24, 0.3F}},
                                {{4, 0.1F}, {9, 0.6F}},
                                {{6, 0.1F}, {15, 0.1F}, {23, 0.5F}},
                                {{2, 0.1F}, {26, 0.6F}}};
const std::vector<std::size_t> kThesisUnknown = {20, 23, 4, 9, 26};

// By trying every way to give contours to class contours: the most matches, then the most weight.
struct PlainMatch {
  int matched = 0;
  double weight = 0;
};

PlainMatch plain_match(const MadeClass& contours, const std::vector<std::size_t>& seen,
                       std::size_t next, unsigned used) {
  if (next == seen.size()) return {};
  PlainMatch best = plain_match(contours, seen, next + 1, used);
  for (std::size_t k = 0; k < contours.size(); ++k) {
    if ((used >> k & 1U) != 0) continue;
    for (const auto& [type, score] : contours[k]) {
      if (type != seen[next]) continue;
      PlainMatch with = plain_match(contours, seen, next + 1, used | 1U << k);
      ++with.matched;
      with.weight += static_cast<double>(score);
      if (std::pair(with.matched, with.weight) > std::pair(best.matched, best.weight)) best = with;
    }
  }
  return best;
}

MadeClass random_class(std::mt19937& random, std::size_t types) {
  MadeClass made(1 + random() % 6);
  for (MadeContour& contour : made)
    for (std::uint16_t type = 0; type < types; ++type)
      if (random() % 3 == 0) contour.emplace_back(type, static_cast<float>(random() % 20));
  return made;
}

}  // namespace

TEST_CASE("the thesis's example matches all five contours with a weight of 2.3") {
  const MadeIndex made = made_index(30, {kThesisClass});
  OwnedMatcher matcher(made.index);
  const ClassMatch match = matcher.match(made.features(kThesisUnknown), 0, Matching::weighted);
  CHECK(match.assignment.matched == 5);
  CHECK(match.score - 5e6 == Approx(2.3).epsilon(1e-6));
  // 1-B, 2-D, 3-A, 4-C, 5-E, as in figure 3.10.
  const std::vector<int> wanted = {1, 3, 0, 2, 4};
  CHECK(std::equal(wanted.begin(), wanted.end(), match.assignment.column_of.begin()));
  CHECK(matcher.match(made.features(kThesisUnknown), 0, Matching::simple).score == 50);
}

TEST_CASE("scores are those of equations 3.8 and 4.2 for more and for fewer contours") {
  const MadeIndex made = made_index(30, {kThesisClass});
  OwnedMatcher matcher(made.index);
  const auto fewer = made.features({20, 23, 4});
  CHECK(matcher.match(fewer, 0, Matching::simple).score == 10 * 3 - 2);
  CHECK(matcher.match(fewer, 0, Matching::weighted).score ==
        Approx(3e6 - 2e5 + 1.1).epsilon(1e-12).margin(1e-6));
  const auto more = made.features({20, 23, 4, 9, 26, 0, 1});
  CHECK(matcher.match(more, 0, Matching::simple).score == 10 * 5 - 2);
  CHECK(matcher.match(more, 0, Matching::weighted).score ==
        Approx(5e6 + 2.3).epsilon(1e-12).margin(1e-6));
  const auto none = made.features({0, 1});
  CHECK(matcher.match(none, 0, Matching::simple).score == -3);
  CHECK(matcher.match(none, 0, Matching::weighted).score == -3e5);
}

TEST_CASE("matches are those that trying all finds, most matches first, then most weight") {
  std::mt19937 random(3);
  constexpr std::size_t kTypes = 8;
  for (int round = 0; round < rounds(500); ++round) {
    const MadeClass contours = random_class(random, kTypes);
    const MadeIndex made = made_index(kTypes, {contours});
    OwnedMatcher matcher(made.index);
    std::vector<std::size_t> seen(1 + random() % 5);
    for (std::size_t& type : seen) type = random() % kTypes;
    const PlainMatch plain = plain_match(contours, seen, 0, 0);
    const ClassMatch match = matcher.match(made.features(seen), 0, Matching::weighted);
    CHECK(match.assignment.matched == plain.matched);
    CHECK(match.assignment.weight == Approx(1e6 * plain.matched + plain.weight).epsilon(1e-12));
    CHECK(matcher.match(made.features(seen), 0, Matching::simple).assignment.matched ==
          plain.matched);
    CHECK(matcher.most_matched(0) >= plain.matched);
  }
}

TEST_CASE("a contour is of the nearest type, the lower one of two as near") {
  MadeIndex made = made_index(40, {});
  for (std::size_t type = 0; type < 40; ++type)
    CHECK(nearest_type(made.index, made.feature_of_type[type]) == type);
  made.index.types.insert(made.index.types.end(), made.index.types.begin(),
                          made.index.types.begin() + 10);
  for (std::size_t type = 0; type < 10; ++type)
    CHECK(nearest_type(made.index, made.feature_of_type[type]) == type);
  std::mt19937 random(4);
  for (int round = 0; round < rounds(300); ++round) {
    const ContourFeature feature = random_feature(random);
    const TypeAttributes attributes = type_attributes(feature);
    const auto distance = [&](const TypeAttributes& type) {
      float sum = 0;
      for (std::size_t d = 0; d < kTypeDimensions; ++d)
        sum += (type[d] - attributes[d]) * (type[d] - attributes[d]);
      return sum;
    };
    const float found = distance(made.index.types[nearest_type(made.index, feature)]);
    for (const TypeAttributes& type : made.index.types) CHECK(found <= distance(type));
  }
}

TEST_CASE("types up to the last that an index may hold are told apart") {
  const MadeIndex made =
      made_index(kMaxTypes, {{{{255, 1.0F}}}, {{{63, 1.0F}, {64, 1.0F}}}, {{{0, 1.0F}}}});
  OwnedMatcher matcher(made.index);
  const auto matched = [&](std::size_t type, std::size_t class_id) {
    const int found =
        matcher.match(made.features({type}), class_id, Matching::simple).assignment.matched;
    CHECK(matcher.most_matched(class_id) == found);
    return found;
  };
  CHECK((matched(255, 0) == 1 && matched(255, 1) == 0 && matched(255, 2) == 0));
  CHECK((matched(63, 1) == 1 && matched(64, 1) == 1 && matched(65, 1) == 0));
  CHECK((matched(0, 2) == 1 && matched(0, 0) == 0 && matched(191, 0) == 0));
}

}  // namespace aspect
