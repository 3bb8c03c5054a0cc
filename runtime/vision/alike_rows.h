// Which pixels of two rows are of one colour ratio: the innermost loops of stage "segment".
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/vision/enhance.h"

namespace aspect {

// core[i] &= the pixels at a[i] and b[i] are alike, or one of them is background.
void require_alike(ShareRow a, ShareRow b, std::size_t count, std::uint8_t intensity_step,
                   std::uint8_t* core);

// link[i] = the pixels at a[i] and b[i] are alike, and both are core. `link` overlaps no other row.
void link_alike(ShareRow a, ShareRow b, const std::uint8_t* core_a, const std::uint8_t* core_b,
                std::size_t count, std::uint8_t intensity_step, std::uint8_t* link);

}  // namespace aspect
