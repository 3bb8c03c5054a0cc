// The search over key views against fits of all of them.
#include "runtime/recognition/view_search.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "runtime/base/portable_math.h"
#include "tests/rounds.h"
#include "tests/runtime/recognition/made_index.h"

namespace aspect {
namespace {

using Features = std::vector<ContourFeature>;

constexpr float kNoLimit = 1e9F;
// Up to so many key views of a class are all fitted.
constexpr std::size_t kFew = 4;
// Fits that cost more are given up, and their cost is not known but for that.
constexpr float kKnown = 4;
// Views nearer than that are one.
constexpr float kNear_cos = 0.94F;

float dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Of a mean of 0, the same on all processors, which the library's distributions are not.
float number_within(float most, std::mt19937& random) {
  constexpr int kSteps = 20001;
  const auto step = static_cast<int>(random() % kSteps) - kSteps / 2;
  return most * static_cast<float>(step) / static_cast<float>(kSteps / 2);
}

Vector3 any_direction(std::mt19937& random) {
  const float x = number_within(1, random), y = number_within(1, random);
  const Vector3 d{x, y, number_within(1, random)};
  const float length = std::sqrt(dot(d, d));
  return {d[0] / length, d[1] / length, d[2] / length};
}

Features random_features(std::mt19937& random) {
  Features features;
  for (std::size_t k = 2 + random() % 4; k > 0; --k) features.push_back(random_feature(random));
  return features;
}

Features shaken(Features features, std::mt19937& random) {
  constexpr float kMost = 0.05F;
  for (ContourFeature& f : features) {
    f.position.x += number_within(kMost, random);
    f.position.y += number_within(kMost, random);
  }
  return features;
}

void add_view(ClassIndex& index, const Vector3& direction, const Features& features) {
  KeyView view{direction,
               {static_cast<std::uint32_t>(index.key_contours.size()),
                static_cast<std::uint32_t>(features.size())}};
  for (std::size_t k = 0; k < features.size(); ++k)
    index.key_contours.push_back({features[k], static_cast<std::uint16_t>(k)});
  index.key_views.push_back(view);
  ++index.classes.back().key_views.count;
}

void add_class(ClassIndex& index) {
  index.classes.emplace_back().key_views.first = static_cast<std::uint32_t>(index.key_views.size());
}

// Classes whose views are of one kind, and now and then of another.
ClassIndex random_index(std::mt19937& random) {
  ClassIndex index;
  for (std::size_t c = 1 + random() % 5; c > 0; --c) {
    add_class(index);
    const Features features = random_features(random);
    for (std::size_t v = 1 + random() % kFew; v > 0; --v) {
      const Vector3 direction = any_direction(random);
      add_view(index, direction,
               random() % 4 == 0 ? random_features(random) : shaken(features, random));
    }
  }
  return index;
}

std::span<const KeyContour> contours_of(const ClassIndex& index, const KeyView& view) {
  return ClassIndex::part(index.key_contours, view.contours);
}

// One of the index's views, turned.
Features seen_of(const ClassIndex& index, std::mt19937& random) {
  const KeyView& view = index.key_views[random() % index.key_views.size()];
  const auto angle = static_cast<double>(number_within(3, random));
  const auto c = static_cast<float>(portable_cos(angle)),
             s = static_cast<float>(portable_sin(angle));
  Features seen;
  for (const KeyContour& contour : contours_of(index, view))
    seen.push_back(turned(contour.feature, c, s));
  return shaken(seen, random);
}

struct PlainFit {
  const KeyView* view = nullptr;
  float cost = 0;
};

// Of a class's views, least cost first.
std::vector<PlainFit> plain_fits(const ClassIndex& index, std::size_t class_id,
                                 const Features& seen) {
  ViewFitter fitter;
  fitter.set_contours(seen);
  std::vector<PlainFit> fits;
  for (const KeyView& view : ClassIndex::part(index.key_views, index.classes[class_id].key_views))
    fits.push_back({&view, fitter.fit(contours_of(index, view), kNoLimit).cost});
  std::stable_sort(fits.begin(), fits.end(),
                   [](const PlainFit& a, const PlainFit& b) { return a.cost < b.cost; });
  return fits;
}

// One hypothesis for each class, and room for more.
struct Searched {
  Searched(const ClassIndex& index, const Features& seen, std::size_t more_room) {
    room.resize(index.classes.size() + more_room);
    for (std::size_t c = 0; c < index.classes.size(); ++c)
      room[c].class_id = static_cast<std::uint16_t>(c);
    search.prepare({&index, 1});
    room.resize(search.run(seen, room, index.classes.size()));
  }
  const Hypothesis& first_of(std::size_t class_id) const {
    return *std::find_if(room.begin(), room.end(), [&](const Hypothesis& h) {
      return h.class_id == class_id && !h.is_second_view;
    });
  }
  std::vector<Vector3> second_directions(std::size_t class_id) const {
    std::vector<Vector3> directions;
    for (const Hypothesis& h : room)
      if (h.class_id == class_id && h.is_second_view) directions.push_back(h.start.key_direction);
    return directions;
  }
  ViewSearch search;
  std::vector<Hypothesis> room;
};

}  // namespace

TEST_CASE("with few key views, the best of each class that fits is the one that all fits show") {
  std::mt19937 random(1);
  int best_right = 0, all = 0;
  for (int round = 0; round < rounds(300); ++round) {
    const ClassIndex index = random_index(random);
    const Features seen = seen_of(index, random);
    const Searched searched(index, seen, 0);
    REQUIRE(searched.room.size() == index.classes.size());
    PlainFit best{nullptr, kNoLimit};
    for (std::size_t c = 0; c < index.classes.size(); ++c) {
      const PlainFit plain = plain_fits(index, c, seen)[0];
      if (plain.cost < best.cost) best = plain;
      if (plain.cost > kKnown) continue;
      const Hypothesis& found = searched.first_of(c);
      CHECK(found.start.key_direction == plain.view->direction);
      CHECK(found.score >= Approx(1 / (1 + static_cast<double>(plain.cost))).epsilon(1e-6));
      CHECK(dot(found.view, found.view) == Approx(1).epsilon(1e-4));
      CHECK(dot(found.view, plain.view->direction) > kNear_cos);
    }
    const Hypothesis& first = *std::min_element(searched.room.begin(), searched.room.end(), better);
    ++all;
    best_right += first.start.key_direction == best.view->direction ? 1 : 0;
    CHECK(first.score == Approx(1 / (1 + static_cast<double>(best.cost))).epsilon(1e-6));
  }
  CHECK(best_right == all);
}

TEST_CASE("second views are the best of those seen from elsewhere that fit about as well") {
  std::mt19937 random(2);
  std::size_t seconds = 0;
  for (int round = 0; round < rounds(300); ++round) {
    const ClassIndex index = random_index(random);
    const Features seen = seen_of(index, random);
    const Searched searched(index, seen, 3 * index.classes.size());
    for (std::size_t c = 0; c < index.classes.size(); ++c) {
      const std::vector<PlainFit> fits = plain_fits(index, c, seen);
      if (fits[0].cost > kKnown) continue;
      std::vector<Vector3> wanted{fits[0].view->direction};
      for (const PlainFit& fit : fits) {
        const bool is_near = std::any_of(wanted.begin(), wanted.end(), [&](const Vector3& other) {
          return dot(other, fit.view->direction) >= kNear_cos;
        });
        if (!is_near && fit.cost <= 1.5F * fits[0].cost + 0.5F && wanted.size() < 3)
          wanted.push_back(fit.view->direction);
      }
      wanted.erase(wanted.begin());
      CHECK(searched.second_directions(c) == wanted);
      seconds += wanted.size();
    }
  }
  CHECK(seconds > 0);
}

TEST_CASE("second views take no more room than there is") {
  std::mt19937 random(3);
  for (int round = 0; round < rounds(100); ++round) {
    const ClassIndex index = random_index(random);
    const Features seen = seen_of(index, random);
    const std::size_t all = Searched(index, seen, 100).room.size(), more = random() % 4;
    CHECK(Searched(index, seen, more).room.size() == std::min(all, index.classes.size() + more));
  }
}

TEST_CASE("a class that is seen from where the best one is comes with half of its score") {
  std::mt19937 random(4);
  const Vector3 here = any_direction(random), elsewhere{-here[0], -here[1], -here[2]};
  ClassIndex index;
  Features seen = random_features(random), other = seen;
  for (ContourFeature& f : other) f.share = {0.05F, 0.05F, 0.9F};
  for (const auto& [direction, features] :
       {std::pair{here, seen}, {here, other}, {elsewhere, other}}) {
    add_class(index);
    add_view(index, direction, features);
  }
  add_class(index);
  const Searched searched(index, seen, 4);
  REQUIRE(searched.room.size() == 4);
  const double best = searched.first_of(0).score;
  CHECK(best > 0.9);
  CHECK(searched.first_of(1).score == Approx(best / 2).epsilon(0.01));
  CHECK(searched.first_of(2).score < 0.2 * best);
  // It has no key view.
  CHECK(searched.first_of(3).score < 1e-9);
}

}  // namespace aspect
