// What stands for colour where a sensor measures something else: three numbers a pixel, alike
// within a surface and different across its border, so that all later stages stay as they are.
#pragma once

#include "runtime/base/arena.h"
#include "runtime/vision/enhance.h"
#include "runtime/vision/planes.h"

namespace aspect {

// Shares whose three colours are those of whatever planes they are given (see show_codes).
Shares take_code_shares(Arena& arena, int width_px, int height_px);

// Lets the shares be the codes themselves, alike where none differs by more than `tolerance`.
void show_codes(const Planes& codes, std::uint8_t tolerance, Shares& shares);

// Of a frame of 16-bit numbers: smallest box of those in [least, most] within the part looked at,
// with a margin of 2 pixels. Empty where there are none.
Box box_of_numbers(const Frame& frame, const VisionParameters& parameters, int least, int most);

// Pixel x, y of such a frame, wherever its bytes lie.
std::uint16_t number_at(const Frame& frame, int x, int y);

}  // namespace aspect
