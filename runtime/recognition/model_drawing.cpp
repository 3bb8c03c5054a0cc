#include "runtime/recognition/model_drawing.h"

#include <algorithm>
#include <cmath>

namespace aspect {

void ModelDrawing::prepare(Arena& arena, std::size_t most_vertices) {
  constexpr auto kCells = static_cast<std::size_t>(kMostCells) * kMostCells;
  points_ = arena.take<StraightPoint>(most_vertices);
  nearness_ = arena.take<float>(kCells);
  colours_ = arena.take<ColourClass>(kCells);
}

bool ModelDrawing::project(const ObjectModel& model, const RigidPose& pose,
                           const CameraModel& camera) {
  if (model.vertices.size() > points_.size()) return false;
  const auto rows = pose.rotation.rows();
  const double nearest = 1e-3 * model.radius;
  point_count_ = model.vertices.size();
  for (std::size_t k = 0; k < point_count_; ++k) {
    const Vector3d& p = model.vertices[k];
    const double z = dot(rows[2], p) + pose.translation[2];
    if (!(z > nearest)) return false;
    const double nearness = 1 / z;
    points_[k] = {
        static_cast<float>(camera.cx_px +
                           camera.fx_px * (dot(rows[0], p) + pose.translation[0]) * nearness),
        static_cast<float>(camera.cy_px +
                           camera.fy_px * (dot(rows[1], p) + pose.translation[1]) * nearness),
        static_cast<float>(nearness)};
  }
  return true;
}

void ModelDrawing::place(const Box& box, int most_cells) {
  float left = static_cast<float>(box.x) - 1, top = static_cast<float>(box.y) - 1;
  float right = static_cast<float>(box.x + box.width),
        bottom = static_cast<float>(box.y + box.height);
  // An object far larger than what is seen of it is drawn as far as it may matter.
  const float reach_x = static_cast<float>(box.width) + 8,
              reach_y = static_cast<float>(box.height) + 8;
  const float least_x = left - reach_x, most_x = right + reach_x, least_y = top - reach_y,
              most_y = bottom + reach_y;
  for (const StraightPoint& p : points()) {
    left = std::min(left, p.x - 1);
    right = std::max(right, p.x + 1);
    top = std::min(top, p.y - 1);
    bottom = std::max(bottom, p.y + 1);
  }
  left = std::max(left, least_x);
  right = std::min(right, most_x);
  top = std::max(top, least_y);
  bottom = std::min(bottom, most_y);
  place(left, top, right, bottom, most_cells);
}

void ModelDrawing::place(float left, float top, float right, float bottom, int most_cells) {
  most_cells = std::clamp(most_cells, 1, kMostCells);
  const auto most = static_cast<float>(most_cells);
  cell_px_ = std::max({1.0F, (right - left) / most, (bottom - top) / most});
  left_px_ = left;
  top_px_ = top;
  width_ = std::clamp(static_cast<int>((right - left) / cell_px_) + 1, 1, most_cells);
  height_ = std::clamp(static_cast<int>((bottom - top) / cell_px_) + 1, 1, most_cells);
}

bool ModelDrawing::draw(const ObjectModel& model, const RigidPose& pose, const CameraModel& camera,
                        const Box& box, int most_cells) {
  if (!project(model, pose, camera)) return false;
  place(box, most_cells);
  fill_all(model);
  return true;
}

bool ModelDrawing::draw_alone(const ObjectModel& model, const RigidPose& pose,
                              const CameraModel& camera, int width_px, int height_px,
                              int most_cells) {
  if (!project(model, pose, camera) || points().empty()) return false;
  float left = points()[0].x, right = left, top = points()[0].y, bottom = top;
  for (const StraightPoint& p : points()) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  constexpr int kMargin = 2;
  const auto width = static_cast<float>(width_px), height = static_cast<float>(height_px);
  left = std::max(left, -width);
  top = std::max(top, -height);
  right = std::min(right, 2 * width);
  bottom = std::min(bottom, 2 * height);
  if (!(left < right && top < bottom)) return false;
  const float margin_px =
      kMargin * std::max({1.0F, (right - left) / static_cast<float>(most_cells - 2 * kMargin),
                          (bottom - top) / static_cast<float>(most_cells - 2 * kMargin)});
  place(left - margin_px, top - margin_px, right + margin_px, bottom + margin_px, most_cells);
  fill_all(model);
  return true;
}

void ModelDrawing::fill_all(const ObjectModel& model) {
  const auto cells = static_cast<std::size_t>(width_ * height_);
  std::fill_n(nearness_.begin(), cells, 0.0F);
  std::fill_n(colours_.begin(), cells, kBackgroundClass);
  for (const ModelTriangle& triangle : model.triangles) fill(triangle);
}

// Row by row between the borders; 1 / depth is linear in the picture.
void ModelDrawing::fill(const ModelTriangle& triangle) {
  std::array<StraightPoint, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    const StraightPoint& q = points_[triangle.corners[k]];
    p[k] = {(q.x - left_px_) / cell_px_ - 0.5F, (q.y - top_px_) / cell_px_ - 0.5F, q.nearness};
  }
  const float ax = p[1].x - p[0].x, ay = p[1].y - p[0].y, bx = p[2].x - p[0].x,
              by = p[2].y - p[0].y;
  const float area = ax * by - ay * bx;
  constexpr float kLeastArea = 1e-6F;
  if (std::abs(area) < kLeastArea) return;
  const float an = p[1].nearness - p[0].nearness, bn = p[2].nearness - p[0].nearness;
  const float by_x = (an * by - bn * ay) / area, by_y = (bn * ax - an * bx) / area;
  const float low = std::min({p[0].y, p[1].y, p[2].y}), high = std::max({p[0].y, p[1].y, p[2].y});
  const int first_row = std::max(0, static_cast<int>(std::ceil(std::max(low, -1.0F))));
  const int last_row = std::min(
      height_ - 1, static_cast<int>(std::floor(std::min(high, static_cast<float>(height_)))));
  for (int row = first_row; row <= last_row; ++row) {
    const auto y = static_cast<float>(row);
    float left = static_cast<float>(width_), right = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const StraightPoint &u = p[k], &v = p[(k + 1) % 3];
      if ((u.y > y) == (v.y > y)) continue;
      const float x = u.x + (v.x - u.x) * (y - u.y) / (v.y - u.y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int begin = static_cast<int>(std::ceil(std::max(left, 0.0F)));
    const int end = std::min(width_ - 1, static_cast<int>(std::floor(std::max(right, -1.0F))));
    for (int column = begin; column <= end; ++column) {
      const float nearness =
          p[0].nearness + by_x * (static_cast<float>(column) - p[0].x) + by_y * (y - p[0].y);
      const auto place = static_cast<std::size_t>(row * width_ + column);
      if (nearness <= nearness_[place]) continue;
      nearness_[place] = nearness;
      colours_[place] = triangle.colour;
    }
  }
}

ModelDrawing::Cell ModelDrawing::at(float x_px, float y_px) const {
  const float x = (x_px - left_px_) / cell_px_, y = (y_px - top_px_) / cell_px_;
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(width_) && y < static_cast<float>(height_)))
    return {};
  return cell(static_cast<int>(x), static_cast<int>(y));
}

}  // namespace aspect
