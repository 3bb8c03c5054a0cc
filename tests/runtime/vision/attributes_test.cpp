#include "runtime/vision/attributes.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

constexpr int kSize_px = 200;

// Corners are drawn to 1/16 of a pixel.
constexpr int kShift = 4;

cv::Point fixed_point(cv::Point2d point) {
  return {cvRound(point.x * (1 << kShift)), cvRound(point.y * (1 << kShift))};
}

cv::Mat polygon_of(const std::vector<cv::Point2d>& corners) {
  cv::Mat picture = cv::Mat::zeros(kSize_px, kSize_px, CV_8UC3);
  std::vector<cv::Point> fixed;
  for (const cv::Point2d& corner : corners) fixed.push_back(fixed_point(corner));
  cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{fixed}, colour(0), cv::LINE_8, kShift);
  return picture;
}

// The image of a unit shape under a random turn, stretch and shear, larger than 30 px.
struct RandomMap {
  double a, b, c, d;
  explicit RandomMap(std::mt19937& random) {
    std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), length(40, 85);
    const double first = angle(random),
                 turn = std::uniform_real_distribution<double>(0.9, 2.2)(random);
    const double p = length(random), q = length(random);
    a = p * std::cos(first);
    c = p * std::sin(first);
    b = q * std::cos(first + turn);
    d = q * std::sin(first + turn);
  }
  cv::Point2d operator()(double x, double y) const {
    return {kSize_px / 2.0 + a * x + b * y, kSize_px / 2.0 + c * x + d * y};
  }
};

void check_close(double found, double expected, double margin) {
  REQUIRE(found == Approx(expected).epsilon(1e-4).margin(margin));
}

// The sums of single precision lose what third orders cancel: 1e-8 is far below the least
// asymmetry that tells shapes apart, 1e-4.
void check_moments(const Contour& contour, const cv::Mat& mask) {
  const cv::Moments m = cv::moments(mask, true);
  check_close(contour.area_px, m.m00, 0);
  check_close(contour.centre_px.x, m.m10 / m.m00, 0);
  check_close(contour.centre_px.y, m.m01 / m.m00, 0);
  check_close(contour.moments.xx, m.nu20, 1e-7);
  check_close(contour.moments.xy, m.nu11, 1e-7);
  check_close(contour.moments.yy, m.nu02, 1e-7);
  check_close(contour.moments.xxx, m.nu30, 1e-7);
  check_close(contour.moments.xxy, m.nu21, 1e-7);
  check_close(contour.moments.xyy, m.nu12, 1e-7);
  check_close(contour.moments.yyy, m.nu03, 1e-7);
  std::array<double, 7> hu{};
  cv::HuMoments(m, hu.data());
  const std::array<float, 4> found = hu_invariants(contour.moments);
  for (std::size_t k = 0; k < 4; ++k) check_close(found[k], hu[k], 1e-8);
}

ShapeClass shape_of(const cv::Mat& picture) {
  OwnedVision vision(kSize_px, kSize_px);
  const ViewGraph graph = vision.run(picture, exact_parameters());
  REQUIRE(graph.contours.size() == 1);
  return graph.contours[0].shape;
}

}  // namespace

TEST_CASE("moments, centres, areas and Hu's invariants are OpenCV's") {
  std::mt19937 random(20);
  for (int round = 0; round < rounds(25); ++round) {
    const cv::Mat picture = polygon_picture(random, {kSize_px, 150}, 3 + round % 6);
    OwnedVision vision(picture.cols, picture.rows);
    const ViewGraph graph = vision.run(picture, exact_parameters());
    const cv::Mat labels = label_picture(vision.regions(), picture.size());
    REQUIRE_FALSE(graph.contours.empty());
    for (const Contour& contour : graph.contours)
      if (contour.external) check_moments(contour, mask_of(labels, contour.region));
  }
}

TEST_CASE("a hole's moments are those of the polygon through its border") {
  cv::Mat picture = cv::Mat::zeros(kSize_px, kSize_px, CV_8UC3);
  picture(cv::Rect(20, 30, 150, 120)) = colour(1);
  cv::fillPoly(picture,
               std::vector<std::vector<cv::Point>>{{{50, 50}, {130, 70}, {110, 130}, {60, 110}}},
               cv::Scalar());
  OwnedVision vision(kSize_px, kSize_px);
  const ViewGraph graph = vision.run(picture, exact_parameters());
  REQUIRE(graph.contours.size() == 2);
  const Contour& hole = graph.contours[1];
  REQUIRE_FALSE(hole.external);
  std::vector<cv::Point> points{{hole.start_x, hole.start_y}};
  for (const std::uint8_t code : hole.chain)
    points.push_back(points.back() + cv::Point(kStepX[code], kStepY[code]));
  points.pop_back();
  const cv::Moments m = cv::moments(points);
  check_close(hole.area_px, m.m00, 0);
  check_close(hole.area_px, cv::contourArea(points), 0);
  check_close(hole.centre_px.x, m.m10 / m.m00, 0);
  check_close(hole.centre_px.y, m.m01 / m.m00, 0);
  check_close(hole.moments.xx, m.nu20, 1e-7);
  check_close(hole.moments.xy, m.nu11, 1e-7);
  check_close(hole.moments.yy, m.nu02, 1e-7);
  check_close(hole.moments.xxx, m.nu30, 1e-6);
  check_close(hole.moments.xxy, m.nu21, 1e-6);
  check_close(hole.moments.xyy, m.nu12, 1e-6);
  check_close(hole.moments.yyy, m.nu03, 1e-6);
  const cv::Rect box = cv::boundingRect(points);
  REQUIRE(hole.box == Box{box.x, box.y, box.width, box.height});
}

TEST_CASE("a hole carries its region's colour and label and lies inside it") {
  cv::Mat picture = cv::Mat::zeros(100, 100, CV_8UC3);
  picture(cv::Rect(10, 10, 80, 80)) = colour(2);
  picture(cv::Rect(40, 40, 20, 20)) = cv::Scalar();
  OwnedVision vision(100, 100);
  const ViewGraph graph = vision.run(picture);
  REQUIRE(graph.contours.size() == 2);
  REQUIRE(graph.contours[0].external);
  REQUIRE(graph.contours[0].inside == 0);
  REQUIRE(graph.contours[1].region == graph.contours[0].region);
  REQUIRE(graph.contours[1].inside == graph.contours[0].region);
  REQUIRE(graph.contours[1].mean_rgb == graph.contours[0].mean_rgb);
}

TEST_CASE("bars of any direction have their thickness") {
  for (int degrees = 0; degrees < 180; degrees += 9) {
    const double angle = degrees * std::numbers::pi / 180;
    const cv::Point2d along(70 * std::cos(angle), 70 * std::sin(angle));
    const cv::Point2d across(-8 * std::sin(angle), 8 * std::cos(angle));
    const cv::Point2d centre(100, 100);
    const cv::Mat picture = polygon_of({centre + along + across, centre + along - across,
                                        centre - along - across, centre - along + across});
    OwnedVision vision(kSize_px, kSize_px);
    const ViewGraph graph = vision.run(picture, exact_parameters());
    REQUIRE(graph.contours.size() == 1);
    // fillPoly paints the pixels that its edges run through, up to half a pixel more a side.
    REQUIRE(graph.contours[0].thickness_px == Approx(16.75).margin(0.75));
  }
}

TEST_CASE("bars along the grid have their thickness exactly") {
  for (int thickness = 3; thickness < 40; thickness += 4)
    for (const cv::Size size : {cv::Size(60, thickness), cv::Size(thickness, 60)}) {
      cv::Mat picture = cv::Mat::zeros(kSize_px, kSize_px, CV_8UC3);
      picture(cv::Rect({10, 20}, size)) = colour(5);
      OwnedVision vision(kSize_px, kSize_px);
      VisionParameters parameters = exact_parameters();
      parameters.thickness_min_px = 0;
      const ViewGraph graph = vision.run(picture, parameters);
      REQUIRE(graph.contours.size() == 1);
      REQUIRE(graph.contours[0].thickness_px == Approx(thickness).epsilon(1e-5));
    }
}

TEST_CASE("shape classes part halfway between the invariants of their ideals") {
  // With unequal second moments, as a shape seen from the side has.
  const auto class_of = [](double invariant) {
    Moments moments;
    moments.xx = 0.2F;
    moments.xy = 0.03F;
    moments.yy = static_cast<float>((invariant + 0.03 * 0.03) / 0.2);
    return shape_class(moments);
  };
  const double ellipse = 1 / (16 * std::numbers::pi * std::numbers::pi);
  const double parallelogram = 1 / 144.0, triangle = 1 / 108.0;
  const double first = (ellipse + parallelogram) / 2, second = (parallelogram + triangle) / 2;
  const double last = triangle + (triangle - parallelogram) / 2;
  for (const double less : {0.999, 1.001}) {
    const bool below = less < 1;
    CHECK(class_of(first * less) == (below ? ShapeClass::circle : ShapeClass::square));
    CHECK(class_of(second * less) == (below ? ShapeClass::square : ShapeClass::triangle));
    CHECK(class_of(last * less) == (below ? ShapeClass::triangle : ShapeClass::other));
  }
}

TEST_CASE("circles and ellipses of any direction are circles") {
  std::mt19937 random(21);
  for (int round = 0; round < rounds(100); ++round) {
    const RandomMap map(random);
    std::vector<cv::Point2d> rim;
    for (int k = 0; k < 180; ++k) {
      const double angle = k * std::numbers::pi / 90;
      rim.push_back(map(std::cos(angle), std::sin(angle)));
    }
    REQUIRE(shape_of(polygon_of(rim)) == ShapeClass::circle);
  }
  for (int radius = 16; radius < 90; radius += 3) {
    cv::Mat picture = cv::Mat::zeros(kSize_px, kSize_px, CV_8UC3);
    cv::circle(picture, {100, 100}, radius, colour(3), cv::FILLED);
    REQUIRE(shape_of(picture) == ShapeClass::circle);
  }
}

TEST_CASE("rectangles and parallelograms of any direction are squares") {
  std::mt19937 random(22);
  for (int round = 0; round < rounds(100); ++round) {
    const RandomMap map(random);
    REQUIRE(shape_of(polygon_of({map(-0.7, -0.7), map(0.7, -0.7), map(0.7, 0.7),
                                 map(-0.7, 0.7)})) == ShapeClass::square);
  }
  for (int side = 31; side < 90; side += 7) {
    cv::Mat picture = cv::Mat::zeros(kSize_px, kSize_px, CV_8UC3);
    picture(cv::Rect(20, 20, 2 * side, side)) = colour(4);
    REQUIRE(shape_of(picture) == ShapeClass::square);
  }
}

TEST_CASE("triangles of any direction are triangles") {
  std::mt19937 random(23);
  for (int round = 0; round < rounds(100); ++round) {
    const RandomMap map(random);
    REQUIRE(shape_of(polygon_of({map(1, 0), map(-0.6, 0.8), map(-0.6, -0.8)})) ==
            ShapeClass::triangle);
  }
}

TEST_CASE("a cross and an L are of no class that they could be mistaken for") {
  cv::Mat cross = cv::Mat::zeros(kSize_px, kSize_px, CV_8UC3);
  cross(cv::Rect(20, 90, 160, 20)) = colour(0);
  cross(cv::Rect(90, 20, 20, 160)) = colour(0);
  REQUIRE(shape_of(cross) == ShapeClass::other);
  cv::Mat corner = cv::Mat::zeros(kSize_px, kSize_px, CV_8UC3);
  corner(cv::Rect(20, 20, 30, 160)) = colour(0);
  corner(cv::Rect(20, 150, 160, 30)) = colour(0);
  REQUIRE(shape_of(corner) == ShapeClass::other);
}

}  // namespace aspect
