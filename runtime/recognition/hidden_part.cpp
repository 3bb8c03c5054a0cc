#include "runtime/recognition/hidden_part.h"

#include <algorithm>

namespace aspect {

void HiddenPart::start(const Box& box) {
  left_px_ = static_cast<float>(box.x);
  top_px_ = static_cast<float>(box.y);
  cells_per_px_ =
      static_cast<float>(kCells) / static_cast<float>(std::max({box.width, box.height, 1}));
  rows_ = {};
  any_ = false;
}

void HiddenPart::hide(const ModelDrawing& drawing, const CameraModel& camera) {
  const float half = drawing.cell_px() / 2;
  for (int row = 0; row < drawing.height(); ++row)
    for (int column = 0; column < drawing.width(); ++column) {
      if (!drawing.cell(column, row).covered) continue;
      const Point2d p = camera.bent(
          {static_cast<double>(drawing.x_px(column)), static_cast<double>(drawing.y_px(row))});
      const float x = static_cast<float>(p.x) - left_px_, y = static_cast<float>(p.y) - top_px_;
      const auto cell_at = [&](float place) {
        return static_cast<int>(std::clamp(place * cells_per_px_, -1.0F, 1.0F * kCells));
      };
      const int first = std::max(0, cell_at(x - half)),
                end = std::min(kCells, cell_at(x + half) + 1);
      const int top = std::max(0, cell_at(y - half)),
                bottom = std::min(kCells, cell_at(y + half) + 1);
      if (x + half < 0 || y + half < 0 || first >= end) continue;
      const std::uint64_t cells =
          (~std::uint64_t{0} >> static_cast<unsigned>(kCells - (end - first)))
          << static_cast<unsigned>(first);
      for (int k = top; k < bottom; ++k) {
        rows_[static_cast<std::size_t>(k)] |= cells;
        any_ = true;
      }
    }
}

}  // namespace aspect
