// A rendered picture as a camera would give it: other light, blur and noise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/render/dice.h"

namespace aspect {

struct MadeFrame {
  int width_px = 0, height_px = 0;
  std::vector<float> rgb;  // 0 to 255, three a pixel, row by row

  float* at(int x, int y) { return &rgb[3 * static_cast<std::size_t>(y * width_px + x)]; }
};

// Of 8 bits a channel, in the same order. The dice say how light it is (0.6 to 1.05), how the light
// is tinted (0.85 to 1.15 a channel), how often it is blurred (up to twice, binomially, three
// pixels wide) and how strong the noise is (0.5 to 3 grey values).
std::vector<std::uint8_t> photographed(MadeFrame frame, Dice& dice);

}  // namespace aspect
