// What has no core of its own: threads of one colour, and the mixed pixels of a blurred edge.
#include "runtime/vision/region_growth.h"

#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <vector>

#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

// Two squares on a ground, with nothing between them yet.
cv::Mat two_squares() {
  cv::Mat picture(80, 120, CV_8UC3, colour(1));
  picture(cv::Rect(10, 30, 25, 25)) = colour(0);
  picture(cv::Rect(80, 20, 25, 25)) = colour(0);
  return picture;
}

// A thread of steps, 4-connected. Unlike straight ones, which have equal pixels on either side, it
// has no core.
void draw_steps(cv::Mat& picture, cv::Point from, int length, const cv::Scalar& value) {
  for (int i = 0; i < length; ++i) picture(cv::Rect(from.x + i, from.y + i, 1, 2)) = value;
}

cv::Mat labels_of(const cv::Mat& picture) {
  OwnedVision vision(picture.cols, picture.rows);
  vision.run(picture, exact_parameters());
  return label_picture(vision.regions(), picture.size());
}

}  // namespace

TEST_CASE("squares joined by a thread one pixel wide are one region, and apart without it") {
  cv::Mat picture = two_squares();
  REQUIRE(same_partition(labels_of(picture), equal_components(picture)));
  picture(cv::Rect(35, 35, 45, 1)) = colour(0);
  REQUIRE(same_partition(labels_of(picture), equal_components(picture)));
  picture = two_squares();
  draw_steps(picture, {35, 32}, 11, colour(0));
  picture(cv::Rect(46, 42, 34, 1)) = colour(0);
  REQUIRE(same_partition(labels_of(picture), equal_components(picture)));
  picture = two_squares();
  for (const cv::Rect& leg :
       {cv::Rect(20, 10, 1, 20), cv::Rect(20, 10, 75, 1), cv::Rect(94, 10, 1, 10)})
    picture(leg) = colour(0);
  REQUIRE(same_partition(labels_of(picture), equal_components(picture)));
}

TEST_CASE("a thread of another colour joins nothing") {
  cv::Mat picture = two_squares();
  draw_steps(picture, {35, 32}, 11, colour(2));
  picture(cv::Rect(46, 42, 34, 1)) = colour(2);
  const cv::Mat labels = labels_of(picture);
  REQUIRE(labels.at<int>(40, 20) != labels.at<int>(30, 90));
}

TEST_CASE("joined regions have the mean colour of both") {
  cv::Mat picture(60, 120, CV_8UC3, colour(1));
  picture(cv::Rect(10, 10, 40, 40)) = cv::Scalar(200, 100, 40);
  picture(cv::Rect(70, 10, 20, 40)) = cv::Scalar(100, 50, 20);
  draw_steps(picture, {50, 15}, 20, cv::Scalar(150, 75, 30));
  OwnedVision vision(120, 60);
  vision.run(picture, exact_parameters());
  const auto regions = vision.regions().regions;
  REQUIRE(regions.size() == 2);
  const Region& joined = regions[1];
  REQUIRE(joined.sums.area == 1600 + 800 + 40);
  // Of the cores alone, which are 38 x 38 and 18 x 38 pixels and may reach into the corners.
  const double share = 38.0 / (38 + 18);
  REQUIRE(joined.mean_rgb[0] == Approx(100 + 100 * share).margin(1));
  REQUIRE(joined.mean_rgb[1] == Approx(50 + 50 * share).margin(1));
  REQUIRE(joined.mean_rgb[2] == Approx(20 + 20 * share).margin(1));
}

TEST_CASE("the border of a blurred edge is where it is half one colour and half the other") {
  for (const double sigma : {0.6, 1.0, 1.4}) {
    cv::Mat picture(60, 100, CV_8UC3, colour(0)), soft;
    picture(cv::Rect(47, 0, 53, 60)) = colour(1);
    cv::GaussianBlur(picture, soft, {}, sigma);
    const cv::Mat labels = labels_of(soft);
    for (int y = 0; y < 60; ++y) {
      const std::set<int> left(labels.ptr<int>(y), labels.ptr<int>(y) + 46);
      const std::set<int> right(labels.ptr<int>(y) + 48, labels.ptr<int>(y) + 100);
      REQUIRE(labels.at<int>(y, 46) != 0);
      REQUIRE(labels.at<int>(y, 47) != 0);
      REQUIRE(left.size() == 1);
      REQUIRE(right.size() == 1);
      REQUIRE(*left.begin() != *right.begin());
    }
  }
}

TEST_CASE("blur wider than a few pixels stays without a label") {
  cv::Mat picture(60, 200, CV_8UC3, colour(0)), soft;
  picture(cv::Rect(100, 0, 100, 60)) = colour(1);
  cv::GaussianBlur(picture, soft, {}, 6.0);
  const cv::Mat labels = labels_of(soft);
  REQUIRE(labels.at<int>(30, 100) == 0);
  REQUIRE(labels.at<int>(30, 5) != 0);
  REQUIRE(labels.at<int>(30, 195) != 0);
  REQUIRE(labels.at<int>(30, 5) != labels.at<int>(30, 195));
}

}  // namespace aspect
