// What of a part of the picture is hidden by objects that are nearer: a mask of 64 x 64 cells.
#pragma once

#include <array>
#include <cstdint>

#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/model_drawing.h"
#include "runtime/vision/frame.h"

namespace aspect {

class HiddenPart {
 public:
  // Nothing of it is hidden.
  void start(const Box& box);

  // What the drawing covers is, in whole cells. O(cells).
  void hide(const ModelDrawing& drawing, const CameraModel& camera);

  bool any() const { return any_; }
  bool hides(float x_px, float y_px) const {
    const int column = static_cast<int>((x_px - left_px_) * cells_per_px_),
              row = static_cast<int>((y_px - top_px_) * cells_per_px_);
    return x_px >= left_px_ && y_px >= top_px_ && column < kCells && row < kCells &&
           (rows_[static_cast<std::size_t>(row)] >> static_cast<unsigned>(column) & 1U) != 0;
  }

 private:
  static constexpr int kCells = 64;

  float left_px_ = 0, top_px_ = 0, cells_per_px_ = 0;
  std::array<std::uint64_t, kCells> rows_{};
  bool any_ = false;
};

}  // namespace aspect
