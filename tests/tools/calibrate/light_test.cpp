// Noise and changing light that are known because they were made.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "runtime/base/planned_memory.h"
#include "runtime/vision/vision.h"
#include "tools/calibrate/light/capture_locks.h"
#include "tools/calibrate/light/noise_model.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

// Steps of grey from dark to light, each of some pixels, that noise of such a camera lies on.
cv::Mat noisy_wedge(double constant, double per_grey, unsigned seed) {
  constexpr int kStep_px = 32, kSteps = 14;
  cv::RNG dice(seed);
  cv::Mat picture(160, kSteps * kStep_px, CV_8UC3);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      for (int c = 0; c < 3; ++c) {
        const double value = 20 + 15.0 * (x / kStep_px);
        picture.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<std::uint8_t>(
            value + dice.gaussian(std::sqrt(constant + per_grey * value)));
      }
  return picture;
}

TEST_CASE("Noise is measured to a tenth between frames and to a fifth within one") {
  struct Case {
    double constant, per_grey;
  };
  for (const Case& c : {Case{2, 0.03}, Case{9, 0}, Case{0.5, 0.12}}) {
    INFO(c.constant << " + " << c.per_grey << " v");
    const auto pair = measure_noise(
        {noisy_wedge(c.constant, c.per_grey, 1), noisy_wedge(c.constant, c.per_grey, 2)});
    REQUIRE(pair);
    CHECK(pair.value().pairs == 1);
    const auto one = measure_noise({noisy_wedge(c.constant, c.per_grey, 3)});
    REQUIRE(one);
    CHECK(one.value().pairs == 0);
    for (const double value : {30.0, 120.0, 200.0}) {
      // Rounding to whole values adds a twelfth.
      const double truth = std::sqrt(c.constant + c.per_grey * value + 1.0 / 12);
      CHECK(pair.value().model.deviation(value) == Approx(truth).epsilon(0.1));
      CHECK(one.value().model.deviation(value) == Approx(truth).epsilon(0.2));
    }
  }
}

TEST_CASE("Frames that show something else are not taken for noise") {
  cv::Mat first = noisy_wedge(4, 0, 1), turned;
  cv::flip(noisy_wedge(4, 0, 2), turned, 1);
  const auto noise = measure_noise({first, turned});
  REQUIRE(noise);
  CHECK(noise.value().pairs == 0);
  CHECK(noise.value().model.deviation(100) == Approx(2).epsilon(0.2));
  CHECK_THAT(measure_noise({cv::Mat(64, 64, CV_8UC3, cv::Scalar(0, 0, 0))}).error(),
             Contains("nothing"));
}

// The share of a noisy patch that vision makes one region.
double largest_region(const cv::Vec3d& bgr, double deviation, const VisionParameters& parameters) {
  cv::RNG dice(7);
  cv::Mat picture(200, 200, CV_8UC3, cv::Scalar(0, 0, 0));
  for (int y = 20; y < 180; ++y)
    for (int x = 20; x < 180; ++x)
      for (int c = 0; c < 3; ++c)
        picture.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<std::uint8_t>(bgr[c] + dice.gaussian(deviation));
  PlannedMemory memory;
  Vision vision;
  memory.plan([&](Arena& arena) { vision.prepare(arena, picture.cols, picture.rows); });
  vision.run({picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step),
              PixelFormat::bgr8},
             parameters);
  double most = 0;
  for (const Region& region : vision.regions().regions)
    most = std::max(most, static_cast<double>(region.sums.area));
  return most / (160 * 160);
}

TEST_CASE("With the noise_steps that follow from the noise, surfaces stay whole") {
  VisionParameters parameters;
  parameters.intensity_step = 765;  // of colours alone
  for (const double deviation : {2.0, 4.0, 8.0}) {
    parameters.noise_steps = noise_steps_for({deviation * deviation, 0}, parameters);
    for (const cv::Vec3d& bgr :
         {cv::Vec3d(20, 30, 40), cv::Vec3d(60, 20, 100), cv::Vec3d(150, 80, 60)}) {
      INFO(deviation << " grey values: noise_steps " << parameters.noise_steps << ", " << bgr[0]);
      CHECK(largest_region(bgr, deviation, parameters) > 0.97);
    }
  }
  // So it is because of them.
  parameters.noise_steps = 0;
  CHECK(largest_region({20, 30, 40}, 8, parameters) < 0.9);
  CHECK(noise_steps_for({0, 0}, parameters) == 0);
  parameters.smooth = false;
  CHECK(noise_steps_for({9, 0}, parameters) > 10);
}

// A room that stands still, and a thing before it that does not.
cv::Mat room(double thing_x, const Eigen::Vector3d& gain) {
  cv::RNG dice(3);
  cv::Mat picture(120, 160, CV_8UC3);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      const bool is_thing = std::abs(x - thing_x) < 20 && std::abs(y - 60) < 25;
      const cv::Vec3d wall(60 + 40 * std::sin(0.1 * x), 110 + 30 * std::cos(0.07 * y),
                           80 + 0.4 * x);
      const cv::Vec3d colour = is_thing ? cv::Vec3d(40, 180, 60) : wall;
      for (int c = 0; c < 3; ++c)
        picture.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<std::uint8_t>(colour[c] * gain[2 - c] + dice.gaussian(1));
    }
  return picture;
}

TEST_CASE("Gains between frames are those of what stands still") {
  const auto gain = gain_between(room(40, {1, 1, 1}), room(90, {1.2, 1.0, 0.9}));
  REQUIRE(gain);
  CHECK((*gain)[0] == Approx(std::log(1.2)).margin(0.015));
  CHECK((*gain)[1] == Approx(0).margin(0.015));
  CHECK((*gain)[2] == Approx(std::log(0.9)).margin(0.015));
  // Another room.
  cv::Mat other;
  cv::flip(room(40, {1, 1, 1}), other, 1);
  CHECK_FALSE(gain_between(room(40, {1, 1, 1}), other));
  CHECK_FALSE(gain_between(room(40, {1, 1, 1}), cv::Mat(10, 10, CV_8UC3, cv::Scalar(90, 90, 90))));
}

TEST_CASE("White balance and exposure that were not locked are told with their controls") {
  const std::vector<std::string> names = {"a.png", "b.png", "c.png"};
  CHECK(lock_warnings({room(40, {1, 1, 1}), room(60, {1, 1, 1}), room(80, {1, 1, 1})}, names)
            .empty());
  const auto exposure = lock_warnings(
      {room(40, {1, 1, 1}), room(60, {1.01, 1.01, 1.01}), room(80, {1.25, 1.25, 1.25})}, names);
  REQUIRE(exposure.size() == 1);
  CHECK_THAT(exposure.front(), Contains("25 % brighter in c.png than in a.png") &&
                                   Contains("auto_exposure") && Contains("exposure_time_absolute"));
  const auto balance =
      lock_warnings({room(40, {1, 1, 1}), room(60, {1.1, 1.0, 0.9}), room(80, {1, 1, 1})}, names);
  REQUIRE(balance.size() == 1);
  CHECK_THAT(balance.front(),
             Contains("a.png and b.png") && Contains("white_balance_automatic = 0"));
}

}  // namespace
}  // namespace aspect
