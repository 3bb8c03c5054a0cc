#include "compiler/index/calibration.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace aspect {

TEST_CASE("Samples that follow a curve give that curve back") {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> agreements(0.8F, 1), dice(0, 1);
  constexpr float kSlope = 60, kEven = 0.9F;
  std::vector<CalibrationSample> samples;
  for (int k = 0; k < 5000; ++k) {
    const float a = agreements(random);
    samples.push_back({a, dice(random) < 1 / (1 + std::exp(kSlope * (kEven - a)))});
  }
  const Calibration found = likeliest_calibration(samples);
  CHECK(found.even == Approx(kEven).margin(0.005));
  CHECK(found.slope == Approx(kSlope).margin(15));
}

TEST_CASE("Samples that are clearly apart are parted between them") {
  const std::vector<CalibrationSample> samples{
      {0.99F, true}, {0.98F, true}, {0.97F, true}, {0.9F, false}, {0.85F, false}, {0.5F, false}};
  const Calibration found = likeliest_calibration(samples);
  CHECK(found.even > 0.9F);
  CHECK(found.even < 0.97F);
}

}  // namespace aspect
