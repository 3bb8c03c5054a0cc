// Textbook argument reductions and power series (Abramowitz and Stegun 1964, 4.1 to 4.4): powers of
// two split off for exp and log, quarter turns for sin and cos, the addition theorem at the nearest
// quarter for the arc tangent. What is left is so small that a few terms of the Taylor series are
// exact to the last bits. Constants are in two or three parts where one double is not enough (Cody
// and Waite 1980). Weak side: a polynomial fitted to the interval would need a third fewer terms.
#include "runtime/base/portable_math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace aspect {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = 0x1.921fb54442d18p+1, kPiRest = 0x1.1a62633145c07p-53;
// 32 bits, so that products with numbers up to 2^20 are exact; the second and third continue it.
constexpr double kQuarterTurn = 0x1.921fb544p+0, kQuarterTurnRest = 0x1.0b4611a6p-34,
                 kQuarterTurnLast = 0x1.3198a2e037073p-69;
constexpr double kLog2 = 0x1.62e42feep-1, kLog2Rest = 0x1.a39ef35793c76p-33;

template <std::size_t kTerms>
double polynomial(const std::array<double, kTerms>& coefficients, double x) {
  double sum = coefficients[kTerms - 1];
  for (std::size_t k = kTerms - 1; k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

// 1 / first!, then every `step`-th, with alternating signs where `sign` is -1.
template <std::size_t kTerms>
constexpr std::array<double, kTerms> inverse_factorials(int first, int step, double sign) {
  std::array<double, kTerms> terms{};
  double factorial = 1, signs = 1;
  for (int k = 2; k <= first; ++k) factorial *= k;
  for (std::size_t n = 0; n < kTerms; ++n) {
    terms[n] = signs / factorial;
    signs *= sign;
    for (int k = 1; k <= step; ++k) factorial *= first + static_cast<int>(n) * step + k;
  }
  return terms;
}

// 1 / 3, 1 / 5, 1 / 7, likewise.
template <std::size_t kTerms>
constexpr std::array<double, kTerms> odd_reciprocals(double sign) {
  std::array<double, kTerms> terms{};
  double signs = sign;
  for (std::size_t n = 0; n < kTerms; ++n) {
    terms[n] = signs / static_cast<double>(2 * n + 3);
    signs *= sign;
  }
  return terms;
}

// 2^k of the normal range.
double power_of_two(int k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52U);
}

// x = quarter * pi / 2 + high + low with |high| a little more than pi / 4 at most.
struct QuarterTurns {
  int quarter = 0;
  double high = 0, low = 0;
};

QuarterTurns quarter_turns(double x_rad) {
  const double quarters = std::floor(x_rad / kQuarterTurn + 0.5);
  const double first = x_rad - quarters * kQuarterTurn, second = quarters * kQuarterTurnRest;
  const double rough = first - second;
  const double lost = (first - rough) - second - quarters * kQuarterTurnLast;
  const double high = rough + lost;
  return {static_cast<int>(quarters) & 3, high, (rough - high) + lost};
}

double sine_of(const QuarterTurns& turns) {
  static constexpr auto kTerms = inverse_factorials<8>(3, 2, -1);
  const double x = turns.high, square = x * x;
  const double rest = -x * square * polynomial(kTerms, square);
  return x + (rest + turns.low * (1 - square / 2));
}

double cosine_of(const QuarterTurns& turns) {
  static constexpr auto kTerms = inverse_factorials<8>(4, 2, -1);
  const double x = turns.high, square = x * x, half = square / 2;
  const double rough = 1 - half;
  return rough +
         ((1 - rough) - half + (square * square * polynomial(kTerms, square) - x * turns.low));
}

// Of 0 <= x <= 1.
double arc_tangent(double x) {
  static constexpr auto kTerms = odd_reciprocals<9>(-1);
  static constexpr std::array<double, 5> kAtQuarter = {
      0, 0x1.f5b75f92c80ddp-3, 0x1.dac670561bb4fp-2, 0x1.4978fa3269ee1p-1, 0x1.921fb54442d18p-1};
  static constexpr std::array<double, 5> kAtQuarterRest = {
      0, 0x1.8ab6e3cf7afbdp-57, 0x1.a2b7f222f65e2p-56, 0x1.2419a87f2a458p-56,
      0x1.1a62633145c07p-55};
  const double quarters = std::floor(4 * x + 0.5), near = quarters / 4;
  const double t = (x - near) / (1 + x * near), square = t * t;
  const auto k = static_cast<std::size_t>(quarters);
  return kAtQuarter[k] + (t + (t * square * polynomial(kTerms, square) + kAtQuarterRest[k]));
}

}  // namespace

double portable_exp(double x) {
  static constexpr auto kTerms = inverse_factorials<13>(2, 1, 1);
  if (std::isnan(x)) return kNan;
  if (x > 709.8) return kInfinity;
  if (x < -745.2) return 0;
  const double twos = std::floor(x / (kLog2 + kLog2Rest) + 0.5);
  const double high = x - twos * kLog2, low = twos * kLog2Rest, rest = high - low;
  const double lost = (high - rest) - low;
  const double scaled = 1 + (rest + (lost + rest * rest * polynomial(kTerms, rest)));
  // In two steps, since the power alone may overflow or be subnormal.
  const int k = static_cast<int>(twos), half = k / 2;
  return scaled * power_of_two(half) * power_of_two(k - half);
}

double portable_log(double x) {
  static constexpr auto kTerms = odd_reciprocals<11>(1);
  if (std::isnan(x) || x < 0) return kNan;
  if (x == 0) return -kInfinity;
  if (x == kInfinity) return kInfinity;
  constexpr int kSubnormalShift = 54;
  constexpr double kLeastNormal = std::numeric_limits<double>::min(), kRootHalf = 0.70710678;
  int twos = 0;
  if (x < kLeastNormal) {
    x *= power_of_two(kSubnormalShift);
    twos = -kSubnormalShift;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  constexpr std::uint64_t kMantissa = 0xFFFFFFFFFFFFFU, kExponentOfHalf = 0x3FEU;
  twos += static_cast<int>(bits >> 52U) - 1022;
  double mantissa = std::bit_cast<double>((bits & kMantissa) | (kExponentOfHalf << 52U));
  if (mantissa < kRootHalf) {
    mantissa *= 2;
    --twos;
  }
  // log(1 + f) = 2 artanh(s), s = f / (2 + f), of which f is the exact part: 2 s = f - s f.
  const double f = mantissa - 1, s = f / (2 + f), square = s * s;
  const double rest = 2 * s * square * polynomial(kTerms, square) - s * f;
  return twos * kLog2 + (f + (rest + twos * kLog2Rest));
}

double portable_sin(double x_rad) {
  if (!(std::abs(x_rad) <= 1e6)) return kNan;
  if (x_rad == 0) return x_rad;
  const QuarterTurns turns = quarter_turns(x_rad);
  const double value = turns.quarter % 2 == 0 ? sine_of(turns) : cosine_of(turns);
  return turns.quarter < 2 ? value : -value;
}

double portable_cos(double x_rad) {
  if (!(std::abs(x_rad) <= 1e6)) return kNan;
  const QuarterTurns turns = quarter_turns(x_rad);
  const double value = turns.quarter % 2 == 0 ? cosine_of(turns) : sine_of(turns);
  return turns.quarter == 0 || turns.quarter == 3 ? value : -value;
}

double portable_tan(double x_rad) {
  if (x_rad == 0) return x_rad;
  return portable_sin(x_rad) / portable_cos(x_rad);
}

double portable_atan(double x) {
  return portable_atan2(x, 1);
}

double portable_atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  const double across = std::abs(x), up = std::abs(y);
  const bool steep = up > across;
  const double least = steep ? across : up, most = steep ? up : across;
  double angle = 0;
  if (most == kInfinity)
    angle = arc_tangent(least == kInfinity ? 1 : 0);
  else if (most > 0)
    angle = arc_tangent(least / most);
  if (steep) angle = kPi / 2 - (angle - kPiRest / 2);
  if (std::signbit(x)) angle = kPi - (angle - kPiRest);
  return std::copysign(angle, y);
}

double portable_acos(double x) {
  if (!(std::abs(x) <= 1)) return kNan;
  return 2 * portable_atan2(std::sqrt(1 - x), std::sqrt(1 + x));
}

float portable_hypot(float x, float y) {
  const auto a = static_cast<double>(x), b = static_cast<double>(y);
  return static_cast<float>(std::sqrt(a * a + b * b));
}

}  // namespace aspect
