#include "runtime/base/portable_math.h"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "runtime/base/fnv1a.h"

namespace aspect {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Distance in units of the last place of the expected value; 0 for equal specials.
double error_ulp(double found, double expected) {
  if (std::isnan(expected)) return std::isnan(found) ? 0 : kInfinity;
  if (found == expected) return std::signbit(found) == std::signbit(expected) ? 0 : kInfinity;
  if (std::isinf(expected) || std::isinf(found)) return kInfinity;
  return std::abs(found - expected) /
         (std::nextafter(std::abs(expected), kInfinity) - std::abs(expected));
}

// Uniform over the values, then over the exponents.
std::vector<double> samples(double low, double high) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> value(low, high), exponent(-40, 0);
  std::vector<double> all;
  for (int k = 0; k < 50'000; ++k) {
    all.push_back(value(random));
    const double scale = std::exp2(exponent(random));
    all.push_back(value(random) * scale);
  }
  return all;
}

constexpr double kSpecials[] = {
    0.0,    -0.0,    1,         -1,         0.5,  -0.5,  2,     1e-3,  1e300, 1e-300,
    5e-324, 1.7e308, kInfinity, -kInfinity, kNan, 0.125, 0.375, 0.625, 0.875, 0.70710678118654752};

template <typename Ours, typename Theirs>
double worst_ulp(Ours&& ours, Theirs&& theirs, double low, double high) {
  double worst = 0;
  for (const double x : samples(low, high)) worst = std::max(worst, error_ulp(ours(x), theirs(x)));
  return worst;
}

// Uniform bits without a library's distribution, which no standard fixes.
struct FixedInputs {
  std::uint64_t state = 42;
  double next(double low, double high) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * (static_cast<double>(state >> 11U) * 0x1p-53);
  }
};

std::uint64_t hashed(std::uint64_t hash, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (unsigned shift = 0; shift < 64; shift += 8)
    hash = fnv1a(hash, static_cast<std::uint8_t>(bits >> shift));
  return hash;
}

}  // namespace

TEST_CASE("portable functions are those of the C library to a few units in the last place") {
  const auto sin = [](double x) { return std::sin(x); };
  const auto cos = [](double x) { return std::cos(x); };
  const auto tan = [](double x) { return std::tan(x); };
  CHECK(worst_ulp(
            portable_exp, [](double x) { return std::exp(x); }, -708, 709) <= 2);
  CHECK(worst_ulp(
            portable_exp, [](double x) { return std::exp(x); }, -1, 1) <= 2);
  CHECK(worst_ulp(
            portable_log, [](double x) { return std::log(x); }, 0, 1e9) <= 2);
  CHECK(worst_ulp(
            portable_log, [](double x) { return std::log(x); }, 0.5, 2) <= 2);
  CHECK(worst_ulp(portable_sin, sin, -7, 7) <= 2);
  CHECK(worst_ulp(portable_sin, sin, -1e6, 1e6) <= 2);
  CHECK(worst_ulp(portable_cos, cos, -7, 7) <= 2);
  CHECK(worst_ulp(portable_cos, cos, -1e6, 1e6) <= 2);
  CHECK(worst_ulp(portable_tan, tan, -7, 7) <= 4);
  CHECK(worst_ulp(
            portable_atan, [](double x) { return std::atan(x); }, -9, 9) <= 3);
  CHECK(worst_ulp(
            portable_acos, [](double x) { return std::acos(x); }, -1, 1) <= 4);
}

TEST_CASE("multiples of a quarter turn keep their small remainders") {
  for (int k = 1; k < 600'000; k += 7) {
    const double x = k * (3.14159265358979323846 / 2);
    REQUIRE(error_ulp(portable_sin(x), std::sin(x)) <= 2);
    REQUIRE(error_ulp(portable_cos(x), std::cos(x)) <= 2);
  }
}

TEST_CASE("portable_atan2 knows all quadrants") {
  FixedInputs inputs;
  for (int k = 0; k < 100'000; ++k) {
    const double y = inputs.next(-5, 5), x = inputs.next(-5, 5);
    REQUIRE(error_ulp(portable_atan2(y, x), std::atan2(y, x)) <= 3);
  }
}

TEST_CASE("portable functions answer special values as the C standard says") {
  for (const double x : kSpecials) {
    INFO(x);
    CHECK(error_ulp(portable_exp(x), std::exp(x)) <= 2);
    CHECK(error_ulp(portable_log(x), std::log(x)) <= 2);
    CHECK(error_ulp(portable_atan(x), std::atan(x)) <= 2);
    CHECK(error_ulp(portable_acos(x), std::acos(x)) <= 2);
    for (const double y : kSpecials) {
      INFO(y);
      CHECK(error_ulp(portable_atan2(y, x), std::atan2(y, x)) <= 2);
    }
    if (std::abs(x) > 1e6) continue;
    CHECK(error_ulp(portable_sin(x), std::sin(x)) <= 2);
    CHECK(error_ulp(portable_cos(x), std::cos(x)) <= 2);
    CHECK(error_ulp(portable_tan(x), std::tan(x)) <= 2);
  }
  for (const double x : {-745.13, -740.0, -710.0, -708.4, 709.7, 709.78, 709.79, 800.0, -800.0})
    CHECK(error_ulp(portable_exp(x), std::exp(x)) <= 2);
  for (const double x : {2e6, -1e9, kInfinity, -kInfinity}) {
    CHECK(std::isnan(portable_sin(x)));
    CHECK(std::isnan(portable_cos(x)));
    CHECK(std::isnan(portable_tan(x)));
  }
}

TEST_CASE("portable_hypot rounds once") {
  FixedInputs inputs;
  for (int k = 0; k < 10'000; ++k) {
    const auto x = static_cast<float>(inputs.next(-3, 3)),
               y = static_cast<float>(inputs.next(-3, 3));
    const long double exact = std::sqrt(static_cast<long double>(x) * static_cast<long double>(x) +
                                        static_cast<long double>(y) * static_cast<long double>(y));
    REQUIRE(portable_hypot(x, y) == static_cast<float>(exact));
  }
  CHECK(std::isfinite(portable_hypot(2e38F, 2e38F)));
  CHECK(portable_hypot(1e-30F, 0) == 1e-30F);
}

// The same number on every machine is the whole point: run this on each of them.
TEST_CASE("results have the same bits on every processor") {
  FixedInputs inputs;
  std::uint64_t hash = kFnv1aStart;
  for (int k = 0; k < 20'000; ++k) {
    hash = hashed(hash, portable_exp(inputs.next(-720, 720)));
    hash = hashed(hash, portable_exp(inputs.next(-2, 2)));
    hash = hashed(hash, portable_log(inputs.next(0, 10)));
    hash = hashed(hash, portable_sin(inputs.next(-7, 7)));
    hash = hashed(hash, portable_cos(inputs.next(-1e6, 1e6)));
    hash = hashed(hash, portable_tan(inputs.next(-7, 7)));
    hash = hashed(hash, portable_atan(inputs.next(-9, 9)));
    hash = hashed(hash, portable_acos(inputs.next(-1, 1)));
    const double up = inputs.next(-5, 5), across = inputs.next(-5, 5);
    hash = hashed(hash, portable_atan2(up, across));
    const float length = portable_hypot(static_cast<float>(up), static_cast<float>(across));
    hash = hashed(hash, static_cast<double>(length));
  }
  for (const double x : kSpecials) {
    hash = hashed(hash, portable_exp(x));
    hash = hashed(hash, portable_log(x));
    hash = hashed(hash, portable_sin(x));
    hash = hashed(hash, portable_atan(x));
    hash = hashed(hash, portable_acos(x));
  }
  CHECK(hash == 0x194fe44574fdc908U);
}

}  // namespace aspect
