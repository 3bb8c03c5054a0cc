// Buckets of pairs and of regions against loops over all contours of all key views.
#include "runtime/recognition/region_pairs.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/recognition/made_index.h"

namespace aspect {
namespace {

constexpr std::array<std::array<float, 3>, 4> kColours{
    {{0.8F, 0.1F, 0.1F}, {0.1F, 0.8F, 0.1F}, {0.1F, 0.1F, 0.8F}, {0.45F, 0.45F, 0.1F}}};
// What no model has.
constexpr std::array<float, 3> kNoColour{1.0F / 3, 1.0F / 3, 1.0F / 3};

// Most contours are of the model's colours, some too small, some in one place.
ContourFeature random_contour(std::mt19937& random) {
  ContourFeature contour = random_feature(random);
  const std::size_t colour = random() % 5;
  contour.share = colour < kColours.size() ? kColours[colour] : kNoColour;
  const float off = std::uniform_real_distribution<float>(-0.03F, 0.03F)(random);
  contour.share[0] += off;
  contour.share[1] -= off;
  if (random() % 6 == 0) contour.area = 0.008F;
  if (random() % 6 == 0) contour.position = {0.01F, 0.01F};
  return contour;
}

ClassIndex random_index(std::mt19937& random) {
  ClassIndex index;
  index.model.shares.assign(kColours.begin(), kColours.end());
  for (std::size_t v = random() % 12; v-- > 0;) {
    KeyView view;
    view.contours = {static_cast<std::uint32_t>(index.key_contours.size()),
                     static_cast<std::uint32_t>(random() % 9)};
    for (std::uint32_t k = 0; k < view.contours.count; ++k)
      index.key_contours.push_back({random_contour(random), static_cast<std::uint16_t>(k)});
    index.key_views.push_back(view);
  }
  return index;
}

struct OwnedPairs {
  explicit OwnedPairs(const ClassIndex& index) {
    memory.plan([&](Arena& arena) { pairs.prepare(arena, index); });
  }
  PlannedMemory memory;
  RegionPairs pairs;
};

// 0: none. A colour's share is at most 0.05 away in what is made above, all others much farther.
int plain_colour(const ContourFeature& contour) {
  for (std::size_t k = 0; k < kColours.size(); ++k)
    if (std::hypot(contour.share[0] - kColours[k][0], contour.share[1] - kColours[k][1],
                   contour.share[2] - kColours[k][2]) < 0.1F)
      return static_cast<int>(k) + 1;
  return 0;
}

bool is_large(const ContourFeature& contour) {
  return contour.area >= 0.01F;
}

using Pair = std::tuple<std::size_t, std::size_t, std::size_t>;  // key view, first, second
using Bucket = std::pair<int, int>;

std::map<Bucket, std::vector<Pair>> plain_pairs(const ClassIndex& index) {
  std::map<Bucket, std::vector<Pair>> buckets;
  for (std::size_t v = 0; v < index.key_views.size(); ++v) {
    const auto contours = ClassIndex::part(index.key_contours, index.key_views[v].contours);
    for (std::size_t i = 0; i < contours.size(); ++i)
      for (std::size_t j = 0; j < contours.size(); ++j) {
        const ContourFeature &a = contours[i].feature, &b = contours[j].feature;
        const int of_a = plain_colour(a), of_b = plain_colour(b);
        const bool in_order = of_a < of_b || (of_a == of_b && i < j);
        const float distance = std::hypot(a.position.x - b.position.x, a.position.y - b.position.y);
        if (i != j && in_order && of_a > 0 && is_large(a) && is_large(b) && distance >= 0.05F)
          buckets[{of_a, of_b}].push_back({v, i, j});
      }
  }
  for (auto& [bucket, pairs] : buckets) std::sort(pairs.begin(), pairs.end());
  return buckets;
}

double plain_size(const ContourFeature& contour, const ContourFeature& a, const ContourFeature& b) {
  const double x = static_cast<double>(a.position.x) - static_cast<double>(b.position.x),
               y = static_cast<double>(a.position.y) - static_cast<double>(b.position.y);
  return static_cast<double>(contour.area) / (x * x + y * y);
}

void check_sizes(const ClassIndex& index, std::span<const RegionPair> pairs) {
  for (const RegionPair& pair : pairs) {
    const auto contours =
        ClassIndex::part(index.key_contours, index.key_views[pair.key_view].contours);
    const ContourFeature &a = contours[pair.first].feature, &b = contours[pair.second].feature;
    CHECK(static_cast<double>(pair.first_size) == Approx(plain_size(a, a, b)).margin(1e-5));
    CHECK(static_cast<double>(pair.second_size) == Approx(plain_size(b, a, b)).margin(1e-5));
  }
}

}  // namespace

TEST_CASE("every pair of neighbouring contours is found once, by its colours, lower one first") {
  std::mt19937 random(1);
  std::size_t all = 0;
  for (int round = 0; round < rounds(200); ++round) {
    const ClassIndex index = random_index(random);
    const OwnedPairs owned(index);
    auto buckets = plain_pairs(index);
    for (int first = 1; first <= 4; ++first)
      for (int second = first; second <= 4; ++second) {
        const auto found =
            owned.pairs.of(static_cast<ColourClass>(first), static_cast<ColourClass>(second));
        std::vector<Pair> pairs;
        for (const RegionPair& pair : found)
          pairs.push_back({pair.key_view, pair.first, pair.second});
        std::sort(pairs.begin(), pairs.end());
        CHECK(pairs == buckets[{first, second}]);
        check_sizes(index, found);
        all += pairs.size();
      }
  }
  CHECK(all > 50);
}

TEST_CASE("every contour of a colour of the model is found once by it, small ones are not") {
  std::mt19937 random(2);
  std::size_t all = 0, left_out = 0;
  for (int round = 0; round < rounds(200); ++round) {
    const ClassIndex index = random_index(random);
    const OwnedPairs owned(index);
    for (std::size_t k = 0; k < index.key_contours.size(); ++k)
      CHECK(owned.pairs.colour_of(k) == plain_colour(index.key_contours[k].feature));
    for (int colour = 0; colour <= 4; ++colour) {
      std::vector<std::pair<std::size_t, std::size_t>> wanted, found;
      for (std::size_t v = 0; v < index.key_views.size(); ++v) {
        const IndexRange range = index.key_views[v].contours;
        for (std::size_t k = range.first; k < range.first + range.count; ++k)
          if (const ContourFeature& contour = index.key_contours[k].feature;
              plain_colour(contour) == colour && is_large(contour))
            wanted.push_back({v, k});
      }
      if (colour == 0) {
        left_out += wanted.size();
        continue;
      }
      for (const KeyRegion& region : owned.pairs.of(static_cast<ColourClass>(colour)))
        found.push_back({region.key_view, region.contour});
      std::sort(found.begin(), found.end());
      CHECK(found == wanted);
      all += found.size();
    }
  }
  CHECK((all > 100 && left_out > 20));
}

TEST_CASE("an index without a model's colours, or without key views, has no pairs") {
  std::mt19937 random(3);
  ClassIndex index;
  index.model.shares.assign(kColours.begin(), kColours.end());
  CHECK(OwnedPairs(index).pairs.of(1, 2).empty());
  CHECK(OwnedPairs(index).pairs.of(4).empty());
  while (index.key_contours.empty()) index = random_index(random);
  index.model.shares.clear();
  const OwnedPairs owned(index);
  for (std::size_t k = 0; k < index.key_contours.size(); ++k)
    CHECK(owned.pairs.colour_of(k) == kBackgroundClass);
}

TEST_CASE("the nearest colour of a model is named, the lower one of two as near, none far away") {
  ObjectModel model;
  model.shares.assign(kColours.begin(), kColours.end());
  for (std::size_t k = 0; k < kColours.size(); ++k)
    CHECK(nearest_colour(model, kColours[k]) == static_cast<ColourClass>(k + 1));
  CHECK(nearest_colour(model, kNoColour) == kBackgroundClass);
  model.shares.push_back(kColours[0]);
  CHECK(nearest_colour(model, kColours[0]) == 1);
  CHECK(nearest_colour({}, kColours[0]) == kBackgroundClass);
}

}  // namespace aspect
