#include "runtime/recognition/view_fit.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/rounds.h"
#include "tests/runtime/recognition/made_index.h"

namespace aspect {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kNoLimit = 1e9F;

using Features = std::vector<ContourFeature>;

// Contours that fill the blob, as those of one picture do: areas add up to one, and the mean place
// is the blob's centre.
Features random_features(std::mt19937& random, std::size_t count) {
  Features features;
  float total = 0;
  for (std::size_t k = 0; k < count; ++k) {
    features.push_back(random_feature(random));
    total += features.back().area;
  }
  Point2 centre;
  for (ContourFeature& f : features) {
    f.area /= total;
    centre.x += f.area * f.position.x;
    centre.y += f.area * f.position.y;
  }
  for (ContourFeature& f : features)
    f.position = {f.position.x - centre.x, f.position.y - centre.y};
  return features;
}

std::vector<KeyContour> key_of(const Features& features) {
  std::vector<KeyContour> key;
  for (const ContourFeature& feature : features)
    key.push_back({feature, static_cast<std::uint16_t>(key.size())});
  return key;
}

Features rolled(Features features, float angle) {
  for (ContourFeature& f : features) f = turned(f, std::cos(angle), std::sin(angle));
  return features;
}

Features mirrored(Features features) {
  for (ContourFeature& f : features) {
    f.position.x = -f.position.x;
    f.moments.xy = -f.moments.xy;
    f.moments.xxx = -f.moments.xxx;
    f.moments.xyy = -f.moments.xyy;
  }
  return features;
}

ViewFit fit(const Features& seen, const Features& key, float give_up = kNoLimit) {
  ViewFitter fitter;
  fitter.set_contours(seen);
  return fitter.fit(key_of(key), give_up);
}

// What a camera on its head costs, and less on the way there.
float roll_cost(float angle) {
  return ViewFitScales{}.roll * (1 - std::cos(angle)) / 2;
}

}  // namespace

TEST_CASE("a view turned by any angle costs its roll only, and the roll is found") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(-kPi, kPi);
  for (int round = 0; round < rounds(600); ++round) {
    const Features key = random_features(random, 1 + static_cast<std::size_t>(round) % 12);
    const float angle = any(random);
    const ViewFit found = fit(rolled(key, angle), key);
    INFO("round " << round << ", turned by " << angle);
    CHECK(found.cost == Approx(roll_cost(angle)).margin(0.01));
    CHECK(std::abs(std::remainder(found.roll_rad - angle, 2 * kPi)) < 0.02F);
    CHECK(found.assignment.matched == static_cast<int>(key.size()));
    for (std::size_t k = 0; k < key.size(); ++k)
      CHECK(found.assignment.column_of[k] == static_cast<int>(k));
  }
}

TEST_CASE("a single contour in the middle is turned by its main axis") {
  std::mt19937 random(2);
  for (int degrees = -170; degrees <= 180; degrees += 10) {
    ContourFeature bar = random_feature(random);
    bar.position = {0, 0};
    bar.area = 1;
    // Without third moments a bar looks the same on its head, and upright is the better guess.
    bar.moments = {0.3F, 0, 0.03F, 0, 0, 0, 0};
    const float angle = static_cast<float>(degrees) * kPi / 180;
    const ViewFit found = fit(rolled({bar}, angle), {bar});
    INFO(degrees << " degrees");
    CHECK(found.cost <= roll_cost(angle) + 0.01F);
    CHECK(std::abs(std::sin(found.roll_rad - angle)) < 0.02F);
  }
}

TEST_CASE("a mirrored view costs clearly more than a turned one") {
  std::mt19937 random(3);
  int close = 0;
  for (int round = 0; round < rounds(300); ++round) {
    const Features key = random_features(random, 3 + static_cast<std::size_t>(round) % 6);
    if (fit(rolled(mirrored(key), static_cast<float>(round)), key).cost < 2) ++close;
  }
  CHECK(close <= 3);
}

TEST_CASE("a missing small contour costs little, a missing large one more") {
  std::mt19937 random(4);
  const ViewFitScales scales;
  for (int round = 0; round < rounds(200); ++round) {
    Features key = random_features(random, 5);
    key[2].area = 0.01F;
    key[3].area = 0.3F;
    Features without_small = key, without_large = key;
    without_small.erase(without_small.begin() + 2);
    without_large.erase(without_large.begin() + 3);
    const float small = scales.missing + 0.01F * scales.missing_area;
    const float large = scales.missing + 0.3F * scales.missing_area;
    CHECK(fit(without_small, key).cost <= small + 0.02F);
    CHECK(fit(key, without_small).cost <= small + 0.02F);
    CHECK(fit(without_large, key).cost > 2 * small);
    CHECK(fit(without_large, key).cost <= large + 0.02F);
  }
}

TEST_CASE("a contour of another colour is matched with nothing") {
  std::mt19937 random(5);
  Features key = random_features(random, 3);
  for (ContourFeature& feature : key) feature.share = {0.1F, 0.1F, 0.8F};
  Features seen = key;
  seen[1].share = {0.8F, 0.1F, 0.1F};
  const ViewFit found = fit(seen, key);
  CHECK(found.assignment.column_of[1] == -1);
  CHECK(found.assignment.matched == 2);
}

TEST_CASE("the cost grows with the noise and never with the number of guesses given up") {
  std::mt19937 random(6);
  std::normal_distribution<float> noise(0, 1);
  double before = 0;
  for (const float size : {0.0F, 0.01F, 0.03F, 0.1F}) {
    double sum = 0;
    for (int round = 0; round < 100; ++round) {
      const Features key = random_features(random, 5);
      Features seen = key;
      for (ContourFeature& f : seen)
        f.position = {f.position.x + size * noise(random), f.position.y + size * noise(random)};
      const ViewFit free = fit(seen, key);
      sum += static_cast<double>(free.cost);
      const ViewFit limited = fit(seen, key, free.cost + 0.01F);
      CHECK(limited.cost == free.cost);
      // Below its cost it is refused with a bound that is above the limit and not above the cost.
      const ViewFit refused = fit(seen, key, free.cost / 2);
      CHECK((refused.cost >= free.cost / 2 && refused.cost <= free.cost + 1e-4F));
    }
    CHECK(sum >= before);
    before = sum;
  }
}

TEST_CASE("nothing seen and nothing known are fitted without harm") {
  std::mt19937 random(7);
  const Features some = random_features(random, 3);
  CHECK(fit({}, {}).cost == 0);
  CHECK(fit(some, {}).cost > 3);
  CHECK(fit({}, some).cost > 3);
  const Features many = random_features(random, kMaxSide);
  CHECK(fit(rolled(many, 1), many).cost < 0.2F);
}

}  // namespace aspect
