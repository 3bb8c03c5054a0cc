// A frame's picture as a page holds it.
#pragma once

#include <string>

#include "runtime/vision/frame.h"

namespace aspect {

// Larger frames are made smaller. A page of 500 frames is to stay under 20 MB: what takes more than
// this, a photograph full of leaves, is compressed harder.
inline constexpr int kMostPagePictureSide_px = 640;
inline constexpr std::size_t kMostPagePictureBytes = 24U << 10U;

// A data URI of a WebP picture. O(pixels), 15 to 35 ms for 512 x 512.
std::string picture_uri(const Frame& frame);

}  // namespace aspect
