// A model drawn at a pose into a small buffer: which colour is seen where, and how far away.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/object_model.h"
#include "runtime/vision/frame.h"

namespace aspect {

// Of a straight picture: see camera_model.h.
struct StraightPoint {
  float x = 0, y = 0;
  float nearness = 0;  // 1 / depth; 0: behind the camera
};

class ModelDrawing {
 public:
  static constexpr int kMostCells = 64;  // along a side

  void prepare(Arena& arena, std::size_t most_vertices);

  // A cell stands for a square of the picture, as small as lets all of the object and of `box` fit
  // into `most_cells` along each side, one pixel at least. False where a part of the object is not
  // before the camera.
  bool draw(const ObjectModel& model, const RigidPose& pose, const CameraModel& camera,
            const Box& box, int most_cells = kMostCells);

  // The same without a box: the object, with two cells around it, as far as it lies near the
  // picture.
  bool draw_alone(const ObjectModel& model, const RigidPose& pose, const CameraModel& camera,
                  int width_px, int height_px, int most_cells);

  std::span<const StraightPoint> points() const { return points_.first(point_count_); }
  int width() const { return width_; }
  int height() const { return height_; }
  float cell_px() const { return cell_px_; }

  // Centre of a cell in the picture.
  float x_px(int column) const { return left_px_ + (static_cast<float>(column) + 0.5F) * cell_px_; }
  float y_px(int row) const { return top_px_ + (static_cast<float>(row) + 0.5F) * cell_px_; }

  struct Cell {
    ColourClass colour = kBackgroundClass;
    bool covered = false;
    float nearness = 0;
  };
  // What the picture shows at a point; uncovered outside of the drawing.
  Cell at(float x_px, float y_px) const;
  Cell cell(int column, int row) const {
    const auto place = static_cast<std::size_t>(row * width_ + column);
    return {colours_[place], nearness_[place] > 0, nearness_[place]};
  }

 private:
  bool project(const ObjectModel& model, const RigidPose& pose, const CameraModel& camera);
  void place(const Box& box, int most_cells);
  void place(float left, float top, float right, float bottom, int most_cells);
  void fill_all(const ObjectModel& model);
  void fill(const ModelTriangle& triangle);

  std::span<StraightPoint> points_;
  std::span<float> nearness_;
  std::span<ColourClass> colours_;
  std::size_t point_count_ = 0;
  int width_ = 0, height_ = 0;
  float left_px_ = 0, top_px_ = 0, cell_px_ = 1;
};

}  // namespace aspect
