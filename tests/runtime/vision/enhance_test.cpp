#include "runtime/vision/enhance.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "runtime/vision/colour_bands.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

void check_median(const cv::Mat& picture, const Box& box, bool smooths) {
  OwnedArena memory(static_cast<std::size_t>(3 * picture.size().area() + 40 * picture.cols) + 512);
  Arena arena = memory.arena();
  Planes planes = take_planes(arena, picture.cols, picture.rows);
  ColourBands bands;
  bands.take(arena, picture.cols);
  for (const auto plane : {planes.red, planes.green, planes.blue})
    std::fill(plane.begin(), plane.end(), std::uint8_t{7});
  bands.run(frame_of(picture), box, smooths, planes);
  REQUIRE(planes.active == box);
  // The filter sees the box alone; OpenCV, the whole picture: inside the rim they see the same.
  cv::Mat median;
  cv::medianBlur(picture, median, 3);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      const int right = box.x + box.width - 1, low = box.y + box.height - 1;
      const bool outside = x < box.x || y < box.y || x > right || y > low;
      const bool rim = x == box.x || y == box.y || x == right || y == low;
      const cv::Vec3b expected =
          outside ? cv::Vec3b(7, 7, 7) : (rim || !smooths ? picture : median).at<cv::Vec3b>(y, x);
      const std::size_t i = planes.place(x, y);
      const cv::Vec3b found(planes.red[i], planes.green[i], planes.blue[i]);
      if (found != expected) FAIL("at " << x << ", " << y << ": " << found << ", not " << expected);
    }
}

// Shares of one row of pixels.
struct OwnedShares {
  std::array<std::vector<std::uint8_t>, 6> planes;
  ShareRow shares{};

  OwnedShares(const std::vector<cv::Vec3b>& pixels, const VisionParameters& parameters) {
    std::array<std::vector<std::uint8_t>, 3> channels;
    for (const cv::Vec3b& pixel : pixels)
      for (int channel = 0; channel < 3; ++channel)
        channels[static_cast<std::size_t>(channel)].push_back(pixel[channel]);
    for (auto& plane : planes) plane.resize(pixels.size());
    const MutableShareRow out = {planes[0].data(), planes[1].data(), planes[2].data(),
                                 planes[3].data(), planes[4].data(), planes[5].data()};
    normalise(channels[0].data(), channels[1].data(), channels[2].data(),
              static_cast<int>(pixels.size()), parameters, out);
    shares = {out.red, out.green, out.blue, out.intensity, out.tolerance, out.foreground};
  }
};

OwnedShares shares_of(const std::vector<cv::Vec3b>& pixels, const VisionParameters& parameters) {
  return {pixels, parameters};
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
    const cv::Size size{1 + static_cast<int>(random() % 70), 1 + static_cast<int>(random() % 30)};
    const cv::Mat picture = noise_picture(random, size);
    check_median(picture, {0, 0, size.width, size.height}, round % 4 != 0);
    const Box part{size.width / 4, size.height / 3, std::max(1, size.width / 2),
                   std::max(1, size.height / 2)};
    check_median(picture, part, round % 4 != 0);
  }
}

TEST_CASE("shares are those of whole-number arithmetic for every colour and brightness") {
  const std::vector<cv::Vec3b> pixels = some_of_all_pixels();
  const OwnedShares owned = shares_of(pixels, {});
  const ShareRow& shares = owned.shares;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const unsigned red = pixels[i][0], green = pixels[i][1], blue = pixels[i][2];
    const unsigned sum = red + green + blue, most = std::max({red, green, blue});
    const unsigned reciprocal = (255U << 16U) / std::max(sum, 1U);
    const bool right = shares.red[i] == (red * reciprocal) >> 16U &&
                       shares.green[i] == (green * reciprocal) >> 16U &&
                       shares.blue[i] == (blue * reciprocal) >> 16U &&
                       shares.intensity[i] == (sum + 2 * most) / 5;
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
