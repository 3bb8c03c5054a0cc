#include "compiler/viewsphere/patch_division.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/compiler/viewsphere/sphere_samples.h"

namespace aspect {
namespace {

Eigen::Vector3d weights_at(double place) {
  const auto edge = static_cast<Eigen::Index>(place);
  const double share = place - static_cast<double>(edge);
  Eigen::Vector3d weights(0, 0, 0);
  weights[edge] = 1 - share;
  weights[(edge + 1) % 3] = share;
  return weights;
}

Eigen::Vector3d random_weights(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  double a = share(random), b = share(random);
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  return {1 - a - b, a, b};
}

// Two to six pieces of different classes.
PatchDivision random_division(std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 3);
  PatchDivision division;
  for (std::size_t k = 0; k < 2 + random() % 5; ++k) division.places.push_back(place(random));
  std::sort(division.places.begin(), division.places.end());
  for (std::size_t k = 0; k < division.places.size(); ++k)
    division.classes.push_back(static_cast<std::int32_t>(k) - 1);
  return division;
}

}  // namespace

TEST_CASE("a chord cuts off the share of a patch that geometry says") {
  // Halfway along both edges from corner 0: a quarter. At a third of the way: a ninth.
  for (const double share : {0.5, 1.0 / 3, 0.9}) {
    const PatchDivision division{{share, 3 - share}, {1, 2}};
    const std::vector<double> shares = piece_shares(division);
    CHECK(shares[1] == Approx(share * share));
    CHECK(shares[0] == Approx(1 - share * share));
    CHECK(class_at(division, {0.99, 0.005, 0.005}) == 2);
    CHECK(class_at(division, {0.01, 0.495, 0.495}) == 1);
  }
}

TEST_CASE("pieces have the area of the points that they hold") {
  std::mt19937 random(2);
  for (int round = 0; round < 40; ++round) {
    const PatchDivision division = random_division(random);
    const std::vector<double> shares = piece_shares(division);
    std::vector<int> hits(shares.size(), 0);
    constexpr int kPoints = 20000;
    for (int k = 0; k < kPoints; ++k)
      ++hits[static_cast<std::size_t>(class_at(division, random_weights(random)) + 1)];
    double sum = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      INFO("round " << round << ", piece " << k);
      CHECK(static_cast<double>(hits[k]) / kPoints == Approx(shares[k]).margin(0.015));
      sum += shares[k];
    }
    CHECK(sum == Approx(1));
  }
}

TEST_CASE("along the edges every class holds from its place to the next") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0, 3);
  for (int round = 0; round < 2000; ++round) {
    const PatchDivision division = random_division(random);
    const double place = anywhere(random);
    std::size_t k = division.places.size() - 1;
    double nearest = 3;
    for (std::size_t i = 0; i < division.places.size(); ++i) {
      if (division.places[i] <= place) k = i;
      nearest = std::min(nearest, std::abs(division.places[i] - place));
    }
    if (place < division.places[0]) k = division.places.size() - 1;
    if (nearest < 0.02) continue;
    const Eigen::Vector3d inside =
        (1 - 1e-7) * weights_at(place) + 1e-7 / 3 * Eigen::Vector3d::Ones();
    CHECK(class_at(division, inside) == division.classes[k]);
  }
}

TEST_CASE("joining keeps the borders between classes and no others") {
  const PatchDivision joint = joined({{0, 0.5, 1, 1.5, 2, 2.5}, {4, 4, 7, 7, kNoClass, 4}});
  CHECK(joint.places == std::vector<double>{1, 2, 2.5});
  CHECK(joint.classes == std::vector<std::int32_t>{7, kNoClass, 4});
  const PatchDivision whole = joined({{0.25, 1, 2}, {5, 5, 5}});
  CHECK(whole.places.size() == 1);
  CHECK(class_at(whole, {0.2, 0.3, 0.5}) == 5);
  CHECK(piece_shares(whole) == std::vector<double>{1});
}

TEST_CASE("a direction is the sum of its patch's corners weighed by its coordinates") {
  std::mt19937 random(4);
  const ViewSphere sphere = uniform_sphere(3);
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Vector3d direction = random_direction(random);
    const PatchId leaf = sphere.locate(direction);
    const Eigen::Vector3d weights = barycentric(sphere, leaf, direction);
    Eigen::Vector3d sum(0, 0, 0);
    for (std::size_t c = 0; c < 3; ++c)
      sum += weights[static_cast<Eigen::Index>(c)] * sphere.position(sphere.patch(leaf).corners[c]);
    CHECK(weights.sum() == Approx(1));
    CHECK(weights.minCoeff() > -1e-9);
    CHECK((sum.normalized() - direction).norm() < 1e-9);
  }
}

}  // namespace aspect
