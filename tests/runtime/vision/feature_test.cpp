#include "runtime/vision/feature.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

constexpr int kSize_px = 180;

// Without the median, which may settle the colours at corners in favour of one or the other.
std::vector<ContourFeature> features_of(const cv::Mat& picture) {
  OwnedVision vision(picture.cols, picture.rows);
  VisionParameters parameters = exact_parameters();
  parameters.one_blob = true;
  const ViewGraph graph = vision.run(picture, parameters);
  std::vector<ContourFeature> features;
  for (const Contour& contour : graph.contours)
    features.push_back(feature_of(contour, graph.blobs[contour.blob]));
  return features;
}

std::array<float, 7> values_of(const Moments& m) {
  return {m.xx, m.xy, m.yy, m.xxx, m.xxy, m.xyy, m.yyy};
}

float difference(const ContourFeature& a, const ContourFeature& b) {
  float most = std::max({std::abs(a.position.x - b.position.x),
                         std::abs(a.position.y - b.position.y), std::abs(a.area - b.area)});
  for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(a.share[k] - b.share[k]));
  const auto p = values_of(a.moments), q = values_of(b.moments);
  for (std::size_t k = 0; k < p.size(); ++k) most = std::max(most, std::abs(p[k] - q[k]));
  return most;
}

// Each feature of `found` has one of `expected` that it equals.
void check_same_features(const std::vector<ContourFeature>& found,
                         const std::vector<ContourFeature>& expected) {
  REQUIRE(found.size() == expected.size());
  for (const ContourFeature& feature : found) {
    float nearest = 1e9F;
    for (const ContourFeature& other : expected)
      nearest = std::min(nearest, difference(feature, other));
    REQUIRE(nearest < 1e-5F);
  }
}

ContourFeature random_feature(std::mt19937& random) {
  std::uniform_real_distribution<float> value(-0.2F, 0.2F);
  ContourFeature feature;
  feature.share = {0.5F, 0.3F, 0.2F};
  feature.position = {value(random), value(random)};
  feature.area = std::abs(value(random));
  feature.moments = {0.1F + std::abs(value(random)),
                     value(random) / 4,
                     0.1F + std::abs(value(random)),
                     value(random) / 4,
                     value(random) / 4,
                     value(random) / 4,
                     value(random) / 4};
  return feature;
}

}  // namespace

TEST_CASE("turning the picture by a quarter turns the features") {
  std::mt19937 random(24);
  for (int round = 0; round < rounds(20); ++round) {
    const cv::Mat picture = polygon_picture(random, {kSize_px, 140}, 3 + round % 5);
    const std::vector<ContourFeature> features = features_of(picture);
    REQUIRE_FALSE(features.empty());
    // From +x to +y, which on the screen is clockwise.
    constexpr std::array<int, 3> kTurns = {cv::ROTATE_90_CLOCKWISE, cv::ROTATE_180,
                                           cv::ROTATE_90_COUNTERCLOCKWISE};
    constexpr std::array<float, 3> kCos = {0, -1, 0}, kSin = {1, 0, -1};
    for (std::size_t k = 0; k < 3; ++k) {
      cv::Mat turned_picture;
      cv::rotate(picture, turned_picture, kTurns[k]);
      std::vector<ContourFeature> expected;
      for (const ContourFeature& feature : features)
        expected.push_back(turned(feature, kCos[k], kSin[k]));
      check_same_features(features_of(turned_picture), expected);
    }
  }
}

TEST_CASE("turns add up") {
  std::mt19937 random(25);
  std::uniform_real_distribution<float> angle(-7, 7);
  for (int round = 0; round < rounds(200); ++round) {
    const ContourFeature feature = random_feature(random);
    const float a = angle(random), b = angle(random);
    const ContourFeature twice =
        turned(turned(feature, std::cos(a), std::sin(a)), std::cos(b), std::sin(b));
    const ContourFeature once = turned(feature, std::cos(a + b), std::sin(a + b));
    REQUIRE(difference(twice, once) < 2e-6F);
    const ContourFeature back =
        turned(turned(feature, std::cos(a), std::sin(a)), std::cos(a), -std::sin(a));
    REQUIRE(difference(back, feature) < 1e-6F);
  }
}

TEST_CASE("moments turn as those of turned points do") {
  std::mt19937 random(26);
  std::uniform_real_distribution<double> value(-1, 1);
  const std::array<double, 2> c_s = {std::cos(0.7), std::sin(0.7)};
  std::array<double, 7> before{}, after{};
  for (int i = 0; i < 20; ++i) {
    const double x = value(random), y = value(random);
    const double u = c_s[0] * x - c_s[1] * y, v = c_s[1] * x + c_s[0] * y;
    const auto add = [](std::array<double, 7>& sums, double p, double q) {
      const std::array<double, 7> terms = {p * p,     p * q,     q * q,    p * p * p,
                                           p * p * q, p * q * q, q * q * q};
      for (std::size_t k = 0; k < 7; ++k) sums[k] += terms[k];
    };
    add(before, x, y);
    add(after, u, v);
  }
  const auto moments = [](const std::array<double, 7>& s) {
    const auto f = [&](std::size_t k) { return static_cast<float>(s[k]); };
    return Moments{f(0), f(1), f(2), f(3), f(4), f(5), f(6)};
  };
  const auto found =
      values_of(turned(moments(before), static_cast<float>(c_s[0]), static_cast<float>(c_s[1])));
  for (std::size_t k = 0; k < 7; ++k)
    REQUIRE(found[k] == Approx(static_cast<float>(after[k])).margin(1e-5));
}

TEST_CASE("a contour's type does not change with turns") {
  std::mt19937 random(27);
  std::uniform_real_distribution<float> angle(-4, 4);
  for (int round = 0; round < rounds(200); ++round) {
    const ContourFeature feature = random_feature(random);
    const float a = angle(random);
    const TypeAttributes before = type_attributes(feature);
    const TypeAttributes after = type_attributes(turned(feature, std::cos(a), std::sin(a)));
    for (std::size_t k = 0; k < kTypeDimensions; ++k)
      REQUIRE(after[k] == Approx(before[k]).epsilon(1e-3).margin(1e-4));
  }
}

TEST_CASE("features do not depend on place, size or brightness") {
  cv::Mat small = cv::Mat::zeros(100, 100, CV_8UC3);
  small(cv::Rect(10, 20, 30, 40)) = cv::Scalar(200, 100, 40);
  small(cv::Rect(40, 20, 20, 20)) = cv::Scalar(40, 100, 200);
  cv::Mat large = cv::Mat::zeros(300, 300, CV_8UC3);
  large(cv::Rect(70, 10, 120, 160)) = cv::Scalar(100, 50, 20);
  large(cv::Rect(190, 10, 80, 80)) = cv::Scalar(20, 50, 100);
  const auto a = features_of(small), b = features_of(large);
  REQUIRE(a.size() == 2);
  REQUIRE(b.size() == 2);
  // Rounded corners and the size of a pixel are all that differs.
  for (std::size_t k = 0; k < 2; ++k) REQUIRE(difference(a[k], b[k]) < 0.004F);
  REQUIRE(difference(a[0], a[1]) > 0.3F);
}

TEST_CASE("a feature is relative to its blob") {
  Contour contour;
  contour.centre_px = {60, 30};
  contour.area_px = 50;
  contour.mean_rgb = {100, 60, 40};
  Blob blob;
  blob.centre_px = {50, 50};
  blob.area_px = 400;
  const ContourFeature feature = feature_of(contour, blob);
  REQUIRE(feature.position.x == Approx(0.5));
  REQUIRE(feature.position.y == Approx(-1.0));
  REQUIRE(feature.area == Approx(0.125));
  REQUIRE(feature.share[0] == Approx(0.5));
  REQUIRE(feature.share[1] == Approx(0.3));
  REQUIRE(feature.share[2] == Approx(0.2));
}

}  // namespace aspect
