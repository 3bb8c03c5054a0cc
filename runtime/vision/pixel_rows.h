// Parts of rows of a colour or grey frame in any of its formats as red, green and blue, exactly the
// same on every machine and whatever part is asked for.
//   rgb8, bgr8, rgbx8, bgrx8, grey8: as they are.
//   yuyv8, uyvy8, nv12, nv21: the matrix of the frame's coding in whole numbers, at most 1 from the
//     exact one; pixels of a pair, or of a square of four, have its chroma.
//   bayer: what the filter leaves out is the rounded mean of the two or four nearest pixels that
//     have it; beyond the frame's edge lies its mirror picture.
#pragma once

#include <cstdint>

#include "runtime/vision/frame.h"
#include "runtime/vision/yuv_rows.h"

namespace aspect {

struct ColourRow {
  std::uint8_t *red, *green, *blue;
};

class PixelRows {
 public:
  // The frame's memory has to outlive this.
  explicit PixelRows(const Frame& frame) : frame_(frame), factors_(yuv_factors(frame.yuv)) {}

  // Pixels [x, x + count) of row y, which the frame must have, from out.red[0] on and so on.
  void colours(int y, int x, int count, ColourRow out) const;

  // Of a grey frame, or the luma of one with Y, U and V.
  void greys(int y, int x, int count, std::uint8_t* out) const;

  // False only where none of the pixels has a channel that reaches `least`. O(count), and fast
  // where it is true.
  bool may_reach(std::uint8_t least, int y, int x, int count) const;

 private:
  const std::uint8_t* row(int y) const { return frame_.data + y * frame_.stride_bytes; }
  YuvPairs pairs(int y) const;

  Frame frame_;
  YuvFactors factors_;
};

// Whether the frame has all the planes, and the even sides, that its format needs.
bool is_whole(const Frame& frame);

}  // namespace aspect
