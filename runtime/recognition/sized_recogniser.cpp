#include "runtime/recognition/sized_recogniser.h"

#include <algorithm>

namespace aspect {

void SizedRecogniser::make_room(int width_px, int height_px) {
  if (width_px <= width_px_ && height_px <= height_px_) return;
  const int width = std::max(width_px, width_px_), height = std::max(height_px, height_px_);
  // Nothing is prepared any more should there be no memory now.
  width_px_ = height_px_ = 0;
  memory_ = {};
  recogniser_ = {};
  memory_.plan(
      [&](Arena& arena) { recogniser_.prepare(arena, indexes_, parameters_, width, height); });
  width_px_ = width;
  height_px_ = height;
}

void SizedRecogniser::cut_with(const VisionParameters& vision) {
  parameters_.vision = vision;
  if (width_px_ == 0 || recogniser_.cut_with(vision)) return;
  const int width = width_px_, height = height_px_;
  width_px_ = height_px_ = 0;
  make_room(width, height);
}

}  // namespace aspect
