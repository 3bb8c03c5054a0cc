#include "runtime/vision/planes.h"

#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <random>

#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

int sum_at(const cv::Mat& picture, int y, int x) {
  const auto& pixel = picture.at<cv::Vec3b>(y, x);
  return pixel[0] + pixel[1] + pixel[2];
}

bool inside(const Box& box, int x, int y) {
  return x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height;
}

bool within(const Box& outer, const Box& inner) {
  return inside(outer, inner.x, inner.y) &&
         inside(outer, inner.x + inner.width - 1, inner.y + inner.height - 1);
}

// A dark picture with a few bright pixels.
cv::Mat sparse_picture(std::mt19937& random, cv::Size size) {
  cv::Mat picture = noise_picture(random, size) / 16;
  for (int i = 0; i < 4; ++i) {
    const int x = static_cast<int>(random() % static_cast<unsigned>(size.width));
    const int y = static_cast<int>(random() % static_cast<unsigned>(size.height));
    picture.at<cv::Vec3b>(y, x)[static_cast<int>(random() % 3)] =
        static_cast<std::uint8_t>(random());
  }
  return picture;
}

void check_holds_foreground(const cv::Mat& picture, const Box& roi, const Box& box,
                            int intensity_min) {
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      if (inside(roi, x, y) && sum_at(picture, y, x) >= intensity_min) REQUIRE(inside(box, x, y));
}

}  // namespace

TEST_CASE("the foreground box holds every foreground pixel of the region of interest") {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const cv::Size size{1 + static_cast<int>(random() % 150), 1 + static_cast<int>(random() % 40)};
    const cv::Mat picture = sparse_picture(random, size);
    VisionParameters parameters;
    parameters.intensity_min = 20 + static_cast<int>(random() % 200);
    const Box whole{0, 0, size.width, size.height};
    check_holds_foreground(picture, whole, foreground_box(frame_of(picture), parameters),
                           parameters.intensity_min);
    parameters.region_of_interest = {size.width / 3, size.height / 3, (size.width + 1) / 2,
                                     (size.height + 1) / 2};
    const Box box = foreground_box(frame_of(picture), parameters);
    check_holds_foreground(picture, parameters.region_of_interest, box, parameters.intensity_min);
    if (!box.empty()) REQUIRE(within(parameters.region_of_interest, box));
  }
}

TEST_CASE("the foreground box fits with a margin of two pixels, less at the frame's edge") {
  cv::Mat picture = cv::Mat::zeros(60, 300, CV_8UC3);
  picture(cv::Rect(100, 20, 50, 10)) = cv::Scalar(0, 200, 0);
  REQUIRE(foreground_box(frame_of(picture), {}) == Box{98, 18, 54, 14});
  picture.at<cv::Vec3b>(0, 299) = {90, 90, 90};
  REQUIRE(foreground_box(frame_of(picture), {}) == Box{98, 0, 202, 32});
  picture.at<cv::Vec3b>(59, 1) = {90, 90, 90};
  REQUIRE(foreground_box(frame_of(picture), {}) == Box{0, 0, 300, 60});
}

TEST_CASE("the margin stays within the region of interest, which is clipped to the frame") {
  const cv::Mat picture(40, 50, CV_8UC3, cv::Scalar(80, 80, 80));
  VisionParameters parameters;
  parameters.region_of_interest = {10, 12, 20, 8};
  REQUIRE(foreground_box(frame_of(picture), parameters) == Box{10, 12, 20, 8});
  parameters.region_of_interest = {-5, 30, 20, 100};
  REQUIRE(foreground_box(frame_of(picture), parameters) == Box{0, 30, 15, 10});
  parameters.region_of_interest = {60, 0, 10, 10};
  REQUIRE(foreground_box(frame_of(picture), parameters).empty());
}

TEST_CASE("a dark picture has no foreground box") {
  const cv::Mat picture(40, 50, CV_8UC3, cv::Scalar(15, 15, 15));
  REQUIRE(foreground_box(frame_of(picture), {}).empty());
}

}  // namespace aspect
