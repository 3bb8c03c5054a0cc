// Rows of Y, U and V in whole numbers of 16 bits, so that vector code and plain code agree to the
// last bit. Matrices: ITU-R BT.601, BT.709 and BT.2020 (constant luminance not used).
#pragma once

#include <cstdint>

#include "runtime/vision/frame.h"

namespace aspect {

// Of a row of pixel pairs: Y of pixel x stands at luma[x * luma_step], U and V of the pair that it
// belongs to at u[x / 2 * chroma_step] and v[x / 2 * chroma_step].
struct YuvPairs {
  const std::uint8_t* luma;
  int luma_step;
  const std::uint8_t *u, *v;
  int chroma_step;
};

// Gain of Y in 1/16384, those of U - 128 and V - 128 in 1/8192.
struct YuvFactors {
  std::int16_t black = 16;
  std::int16_t luma = 0, red_v = 0, green_u = 0, green_v = 0, blue_u = 0;
};

YuvFactors yuv_factors(const YuvCoding& coding);

// Pixels [x, x + count) of a row of pairs; x and count may be odd.
void yuv_row(const YuvPairs& pairs, const YuvFactors& factors, int x, int count, std::uint8_t* red,
             std::uint8_t* green, std::uint8_t* blue);

// What these pixels would be without chroma.
void luma_row(const YuvPairs& pairs, const YuvFactors& factors, int x, int count,
              std::uint8_t* out);

// False only where none of these pixels has a channel that reaches `least`.
bool yuv_may_reach(const YuvPairs& pairs, const YuvFactors& factors, std::uint8_t least, int x,
                   int count);

}  // namespace aspect
