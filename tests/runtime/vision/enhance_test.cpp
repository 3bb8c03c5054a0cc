#include "runtime/vision/enhance.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

// Planes with memory of their own.
struct OwnedPlanes {
  OwnedArena memory;
  Planes planes;
  explicit OwnedPlanes(cv::Size size) : memory(static_cast<std::size_t>(3 * size.area() + 3 * 64)) {
    Arena arena = memory.arena();
    planes = take_planes(arena, size.width, size.height);
  }
};

struct OwnedShares {
  OwnedArena memory;
  Shares shares;
  explicit OwnedShares(cv::Size size) : memory(static_cast<std::size_t>(6 * size.area() + 6 * 64)) {
    Arena arena = memory.arena();
    shares = take_shares(arena, size.width, size.height);
  }
};

void check_median(const cv::Mat& picture, const Box& box) {
  OwnedPlanes from(picture.size()), to(picture.size());
  split_planes(frame_of(picture), box, from.planes);
  std::vector<std::uint8_t> scratch(static_cast<std::size_t>(3 * picture.cols));
  smooth(from.planes, scratch, to.planes);
  REQUIRE(to.planes.active == box);
  // The filter sees the box alone; OpenCV, the whole picture: inside the rim they see the same.
  cv::Mat median;
  cv::medianBlur(picture, median, 3);
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x) {
      const bool rim =
          x == box.x || y == box.y || x + 1 == box.x + box.width || y + 1 == box.y + box.height;
      const auto& expected = (rim ? picture : median).at<cv::Vec3b>(y, x);
      const auto i = static_cast<std::size_t>(y * to.planes.stride_px + x);
      const cv::Vec3b found(to.planes.red[i], to.planes.green[i], to.planes.blue[i]);
      if (found != expected) FAIL("at " << x << ", " << y << ": " << found << ", not " << expected);
    }
}

// Shares of one row of pixels.
OwnedShares shares_of(const std::vector<cv::Vec3b>& pixels, const VisionParameters& parameters) {
  const cv::Size size(static_cast<int>(pixels.size()), 1);
  const cv::Mat picture(size, CV_8UC3, const_cast<cv::Vec3b*>(pixels.data()));
  OwnedPlanes planes(size);
  split_planes(frame_of(picture), {0, 0, size.width, 1}, planes.planes);
  OwnedShares shares(size);
  normalise(planes.planes, parameters, shares.shares);
  return shares;
}

std::vector<cv::Vec3b> some_of_all_pixels() {
  std::vector<cv::Vec3b> pixels;
  for (unsigned red = 0; red < 256; ++red)
    for (unsigned green = 0; green < 256; ++green)
      for (unsigned blue = (red * 5 + green * 3) % 17; blue < 256; blue += 17)
        pixels.emplace_back(static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                            static_cast<std::uint8_t>(blue));
  return pixels;
}

}  // namespace

TEST_CASE("the median is OpenCV's inside the rim, and the rim is copied") {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    const cv::Size size(1 + static_cast<int>(random() % 70), 1 + static_cast<int>(random() % 30));
    const cv::Mat picture = noise_picture(random, size);
    check_median(picture, {0, 0, size.width, size.height});
    const Box part{size.width / 4, size.height / 3, std::max(1, size.width / 2),
                   std::max(1, size.height / 2)};
    check_median(picture, part);
  }
}

TEST_CASE("shares are those of whole-number arithmetic for every colour and brightness") {
  const std::vector<cv::Vec3b> pixels = some_of_all_pixels();
  const OwnedShares owned = shares_of(pixels, {});
  const Shares& shares = owned.shares;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const unsigned red = pixels[i][0], green = pixels[i][1], blue = pixels[i][2];
    const unsigned sum = red + green + blue;
    const unsigned reciprocal = (255U << 16U) / std::max(sum, 1U);
    const bool right = shares.red[i] == (red * reciprocal) >> 16U &&
                       shares.green[i] == (green * reciprocal) >> 16U &&
                       shares.blue[i] == (blue * reciprocal) >> 16U &&
                       shares.intensity[i] == sum / 3;
    if (!right) FAIL("shares of " << pixels[i]);
  }
}

TEST_CASE("shares of one colour at any brightness are nearly the same") {
  std::vector<cv::Vec3b> pixels;
  for (int level = 4; level <= 50; ++level)
    pixels.emplace_back(static_cast<std::uint8_t>(5 * level), static_cast<std::uint8_t>(2 * level),
                        static_cast<std::uint8_t>(level));
  const OwnedShares owned = shares_of(pixels, {});
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    REQUIRE(std::abs(owned.shares.red[i] - 159) <= 1);
    REQUIRE(std::abs(owned.shares.green[i] - 63) <= 1);
    REQUIRE(std::abs(owned.shares.blue[i] - 31) <= 1);
  }
}

TEST_CASE("tolerance grows as pixels darken and foreground starts at the least intensity") {
  std::vector<cv::Vec3b> pixels;
  for (int level = 0; level <= 255; ++level) {
    const auto value = static_cast<std::uint8_t>(level);
    pixels.emplace_back(value, value, value);
    pixels.emplace_back(value, value / 2, value / 3);
  }
  for (const int noise_steps : {0, 1, 3, 40, 100000}) {
    for (const int intensity_min : {-5, 0, 1, 48, 150, 765, 766, 100000}) {
      VisionParameters parameters;
      parameters.chroma_step = 9;
      parameters.noise_steps = noise_steps;
      parameters.intensity_min = intensity_min;
      const OwnedShares owned = shares_of(pixels, parameters);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int sum = pixels[i][0] + pixels[i][1] + pixels[i][2];
        const bool foreground = sum >= std::max(intensity_min, 1);
        REQUIRE(owned.shares.foreground[i] == (foreground ? 255 : 0));
        if (foreground)
          REQUIRE(owned.shares.tolerance[i] == std::min(255, 9 + noise_steps * 255 / sum));
      }
    }
  }
}

}  // namespace aspect
