// Products of 16 by 16 bits of which the upper half is kept leave five bits behind the point: all
// sums fit 16 bits, which vectors have twice as many of as of 32, and are within 0.1 of the exact
// ones before they are rounded. Blocks of a fixed length, with what stands beside the part asked
// for if need be, keep the loops free of special cases.
#include "runtime/vision/yuv_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace aspect {
namespace {

using Byte = std::uint8_t;
using Word = std::int16_t;

constexpr int kPairs = 32;  // of a block
constexpr int kFractionBits = 5;
// A half, and another half for each of the two or three halves of a unit that products lose.
constexpr int kRounding = (1 << (kFractionBits - 1)) + 1;

inline Word upper_half(Word a, Word b) {
  return static_cast<Word>((static_cast<std::int32_t>(a) * b) >> 16);
}

inline Byte rounded(Word value) {
  const auto whole = static_cast<Word>(static_cast<Word>(value + kRounding) >> kFractionBits);
  return static_cast<Byte>(std::clamp<Word>(whole, 0, 255));
}

struct Block {
  Byte y[2 * kPairs], u[kPairs], v[kPairs];
};

// Pairs [first, first + kPairs), or as many as there are.
void load(const YuvPairs& pairs, int first, int count, Block& block) {
  const Byte* __restrict luma = pairs.luma + 2 * first * pairs.luma_step;
  const Byte* __restrict u = pairs.u + first * pairs.chroma_step;
  const Byte* __restrict v = pairs.v + first * pairs.chroma_step;
  const int least = std::min(count, kPairs);
  if (least == kPairs && pairs.luma_step == 2) {
    for (int i = 0; i < 2 * kPairs; ++i) block.y[i] = luma[2 * i];
    for (int i = 0; i < kPairs; ++i) {
      block.u[i] = u[4 * i];
      block.v[i] = v[4 * i];
    }
    return;
  }
  for (int i = 0; i < 2 * least; ++i) block.y[i] = luma[i * pairs.luma_step];
  for (int i = 0; i < least; ++i) {
    block.u[i] = u[i * pairs.chroma_step];
    block.v[i] = v[i * pairs.chroma_step];
  }
}

// Of each pair, what its chroma adds to red, green and blue.
struct Tints {
  Word red[2 * kPairs], green[2 * kPairs], blue[2 * kPairs];
};

void tint(const Block& block, const YuvFactors& factors, Tints& tints) {
  for (int i = 0; i < kPairs; ++i) {
    const auto u = static_cast<Word>((block.u[i] - 128) * 256);
    const auto v = static_cast<Word>((block.v[i] - 128) * 256);
    const Word red = upper_half(v, factors.red_v), blue = upper_half(u, factors.blue_u);
    const auto green =
        static_cast<Word>(upper_half(u, factors.green_u) + upper_half(v, factors.green_v));
    tints.red[2 * i] = tints.red[2 * i + 1] = red;
    tints.green[2 * i] = tints.green[2 * i + 1] = green;
    tints.blue[2 * i] = tints.blue[2 * i + 1] = blue;
  }
}

inline Word scaled_luma(Byte y, const YuvFactors& factors) {
  return upper_half(static_cast<Word>((y - factors.black) * 128), factors.luma);
}

void colour(const Block& block, const YuvFactors& factors, Byte* __restrict red,
            Byte* __restrict green, Byte* __restrict blue) {
  Tints tints;
  tint(block, factors, tints);
  for (int i = 0; i < 2 * kPairs; ++i) {
    const Word luma = scaled_luma(block.y[i], factors);
    red[i] = rounded(static_cast<Word>(luma + tints.red[i]));
    green[i] = rounded(static_cast<Word>(luma + tints.green[i]));
    blue[i] = rounded(static_cast<Word>(luma + tints.blue[i]));
  }
}

// An upper bound of the channels, in 1/16384, of luma and distance from grey.
inline int brightest(int luma, int tint, const YuvFactors& factors) {
  constexpr int kSlack = 2 * 16384;
  return (luma - factors.black) * factors.luma + 2 * tint * factors.blue_u + kSlack;
}

}  // namespace

YuvFactors yuv_factors(const YuvCoding& coding) {
  double red = 0.299, blue = 0.114;
  if (coding.matrix == YuvMatrix::bt709) {
    red = 0.2126;
    blue = 0.0722;
  } else if (coding.matrix == YuvMatrix::bt2020) {
    red = 0.2627;
    blue = 0.0593;
  }
  const double green = 1 - red - blue;
  const double luma_gain = coding.full_range ? 1 : 255.0 / 219;
  const double chroma_gain = coding.full_range ? 2 : 2 * 255.0 / 224;
  const auto fixed = [](double gain, int one) {
    return static_cast<Word>(std::lround(gain * one));
  };
  constexpr int kLuma = 16384, kChroma = 8192;
  YuvFactors factors;
  factors.black = coding.full_range ? 0 : 16;
  factors.luma = fixed(luma_gain, kLuma);
  factors.red_v = fixed(chroma_gain * (1 - red), kChroma);
  factors.green_u = fixed(-chroma_gain * (1 - blue) * blue / green, kChroma);
  factors.green_v = fixed(-chroma_gain * (1 - red) * red / green, kChroma);
  factors.blue_u = fixed(chroma_gain * (1 - blue), kChroma);
  return factors;
}

void yuv_row(const YuvPairs& pairs, const YuvFactors& factors, int x, int count, Byte* red,
             Byte* green, Byte* blue) {
  Block block{};
  const int end = x + count;
  for (int first = x / 2; 2 * first < end; first += kPairs) {
    load(pairs, first, (end + 1) / 2 - first, block);
    const int from = std::max(x, 2 * first), to = std::min(end, 2 * (first + kPairs));
    if (to - from == 2 * kPairs) {
      colour(block, factors, red + from - x, green + from - x, blue + from - x);
      continue;
    }
    Byte part[3][2 * kPairs];
    colour(block, factors, part[0], part[1], part[2]);
    const auto length = static_cast<std::size_t>(to - from);
    std::memcpy(red + from - x, part[0] + from - 2 * first, length);
    std::memcpy(green + from - x, part[1] + from - 2 * first, length);
    std::memcpy(blue + from - x, part[2] + from - 2 * first, length);
  }
}

void luma_row(const YuvPairs& pairs, const YuvFactors& factors, int x, int count, Byte* out) {
  const Byte* luma = pairs.luma + x * pairs.luma_step;
  for (int i = 0; i < count; ++i) out[i] = rounded(scaled_luma(luma[i * pairs.luma_step], factors));
}

bool yuv_may_reach(const YuvPairs& pairs, const YuvFactors& factors, Byte least, int x, int count) {
  Block block{};
  const int end = (x + count + 1) / 2, enough = least * 16384;
  for (int first = x / 2; first < end; first += kPairs) {
    load(pairs, first, end - first, block);
    const int have = std::min(end - first, kPairs);
    Byte luma = 0, lowest = 255, highest = 0;
    for (int i = 0; i < 2 * have; ++i) luma = std::max(luma, block.y[i]);
    for (int i = 0; i < have; ++i) {
      lowest = std::min({lowest, block.u[i], block.v[i]});
      highest = std::max({highest, block.u[i], block.v[i]});
    }
    if (brightest(luma, std::max(128 - lowest, highest - 128), factors) >= enough) return true;
  }
  return false;
}

}  // namespace aspect
