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

// Parted by their places in a pair, which vector units load at once.
struct Block {
  Byte even[kPairs], odd[kPairs], u[kPairs], v[kPairs];
};

void split2(const Byte* __restrict from, Byte* __restrict first, Byte* __restrict second) {
  for (int i = 0; i < kPairs; ++i) {
    first[i] = from[2 * i];
    second[i] = from[2 * i + 1];
  }
}

void split4(const Byte* __restrict from, Byte* __restrict first, Byte* __restrict second,
            Byte* __restrict third, Byte* __restrict fourth) {
  for (int i = 0; i < kPairs; ++i) {
    first[i] = from[4 * i];
    second[i] = from[4 * i + 1];
    third[i] = from[4 * i + 2];
    fourth[i] = from[4 * i + 3];
  }
}

bool is_packed(const YuvPairs& pairs) {
  return pairs.luma_step == 2;
}

// Four bytes a pair.
const Byte* packed(const YuvPairs& pairs, int first) {
  return std::min(pairs.luma, pairs.u) + 4 * first;
}

// Two bytes a pair, in a plane of their own.
const Byte* chroma(const YuvPairs& pairs, int first) {
  return std::min(pairs.u, pairs.v) + 2 * first;
}

// Of a block at the end of a row, what there is of it, and zeros.
class Padded {
 public:
  const Byte* operator()(const Byte* from, int have, int wanted) {
    if (have >= wanted) return from;
    std::memcpy(room_, from, static_cast<std::size_t>(have));
    return room_;
  }

 private:
  Byte room_[4 * kPairs] = {};
};

// Pairs [first, first + count), at most kPairs of them.
void load(const YuvPairs& pairs, int first, int count, Block& block) {
  Padded padded, padded_luma;
  if (is_packed(pairs)) {
    const Byte* from = padded(packed(pairs, first), 4 * count, 4 * kPairs);
    if (pairs.luma < pairs.u)
      split4(from, block.even, block.u, block.odd, block.v);
    else
      split4(from, block.u, block.even, block.v, block.odd);
    return;
  }
  split2(padded_luma(pairs.luma + 2 * first, 2 * count, 2 * kPairs), block.even, block.odd);
  const Byte* from = padded(chroma(pairs, first), 2 * count, 2 * kPairs);
  if (pairs.u < pairs.v)
    split2(from, block.u, block.v);
  else
    split2(from, block.v, block.u);
}

// Of each pair, what its chroma adds to red, green and blue.
struct Tints {
  Word red[kPairs], green[kPairs], blue[kPairs];
};

void tint(const Block& block, const YuvFactors& factors, Tints& tints) {
  for (int i = 0; i < kPairs; ++i) {
    const auto u = static_cast<Word>((block.u[i] - 128) * 256);
    const auto v = static_cast<Word>((block.v[i] - 128) * 256);
    tints.red[i] = upper_half(v, factors.red_v);
    tints.green[i] =
        static_cast<Word>(upper_half(u, factors.green_u) + upper_half(v, factors.green_v));
    tints.blue[i] = upper_half(u, factors.blue_u);
  }
}

inline Word scaled_luma(Byte y, const YuvFactors& factors) {
  return upper_half(static_cast<Word>((y - factors.black) * 128), factors.luma);
}

struct Lumas {
  Word even[kPairs], odd[kPairs];
};

void channel(const Lumas& lumas, const Word* __restrict tint, Byte* __restrict out) {
  for (int i = 0; i < kPairs; ++i) {
    out[2 * i] = rounded(static_cast<Word>(lumas.even[i] + tint[i]));
    out[2 * i + 1] = rounded(static_cast<Word>(lumas.odd[i] + tint[i]));
  }
}

void colour(const Block& block, const YuvFactors& factors, Byte* red, Byte* green, Byte* blue) {
  Tints tints;
  tint(block, factors, tints);
  Lumas lumas;
  for (int i = 0; i < kPairs; ++i) {
    lumas.even[i] = scaled_luma(block.even[i], factors);
    lumas.odd[i] = scaled_luma(block.odd[i], factors);
  }
  channel(lumas, tints.red, red);
  channel(lumas, tints.green, green);
  channel(lumas, tints.blue, blue);
}

struct Extremes {
  Byte luma = 0, lowest = 255, highest = 0;

  void add(Byte y, Byte chroma) {
    luma = std::max(luma, y);
    lowest = std::min(lowest, chroma);
    highest = std::max(highest, chroma);
  }
};

// Of as many luma as chroma bytes: U and V alike stand beside the luma of one pixel.
template <typename Layout>
inline Extremes extremes(Layout layout, int bytes) {
  Extremes all;
  for (int i = 0; i < bytes; ++i) all.add(layout.luma(i), layout.chroma(i));
  return all;
}

template <int kLumaPlace>
struct PackedLayout {
  const Byte* from;
  Byte luma(int i) const { return from[2 * i + kLumaPlace]; }
  Byte chroma(int i) const { return from[2 * i + 1 - kLumaPlace]; }
};

struct PlanarLayout {
  const Byte *lumas, *chromas;
  Byte luma(int i) const { return lumas[i]; }
  Byte chroma(int i) const { return chromas[i]; }
};

// A whole block has a length that the compiler knows.
template <typename Layout>
Extremes extremes_of_pairs(Layout layout, int count) {
  return count == kPairs ? extremes(layout, 2 * kPairs) : extremes(layout, 2 * count);
}

Extremes extremes_of(const YuvPairs& pairs, int first, int count) {
  if (!is_packed(pairs))
    return extremes_of_pairs(PlanarLayout{pairs.luma + 2 * first, chroma(pairs, first)}, count);
  const Byte* from = packed(pairs, first);
  return pairs.luma < pairs.u ? extremes_of_pairs(PackedLayout<0>{from}, count)
                              : extremes_of_pairs(PackedLayout<1>{from}, count);
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
    load(pairs, first, std::min((end + 1) / 2 - first, kPairs), block);
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
  const int end = (x + count + 1) / 2, enough = least * 16384;
  for (int first = x / 2; first < end; first += kPairs) {
    const auto [luma, lowest, highest] = extremes_of(pairs, first, std::min(end - first, kPairs));
    if (brightest(luma, std::max(128 - lowest, highest - 128), factors) >= enough) return true;
  }
  return false;
}

}  // namespace aspect
