// Which 4x4-pixel tiles of a view can show which primitive: what spares most rays.
//
// Idea: a tile that lies wholly inside the picture of one flat convex piece (a plate), and there
// everything else that touches the tile is farther away, shows that primitive and nothing else. Its
// depth follows from the plane. Only the other tiles that something touches need rays.
// Steps: project all points; for every plate and tile inside it keep the nearest plate; then for
// every primitive and tile it touches withdraw the tile unless the plate is nearer all over it.
// Weak side: the work grows with the depth of overlap; curved surfaces always need rays.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/render/camera.h"
#include "compiler/render/scene_outline.h"
#include "runtime/vision/frame.h"

namespace aspect {

// 1 / depth = x * column_px + y * row_px + constant: what a plane's picture is.
struct InverseDepth {
  double x = 0, y = 0, constant = 0;
  double at(double column_px, double row_px) const { return x * column_px + y * row_px + constant; }
};

class TileMap {
 public:
  static constexpr int kTile = 4;               // pixels a side: 16 of them are one packet of rays
  static constexpr std::int32_t kNothing = -1;  // background for certain
  static constexpr std::int32_t kContested = -2;  // needs rays

  // Works out every tile of a view. The memory is kept from view to view.
  void classify(const SceneOutline& outline, const Camera& camera);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  // kNothing, kContested or the index of the one primitive that fills the tile; left to right.
  const std::int32_t* row(int row) const { return owner_.data() + offset(row); }
  // Of a primitive that fills a tile.
  const InverseDepth& inverse_depth(std::int32_t primitive) const {
    return bodies_[static_cast<std::size_t>(primitive)].plane;
  }
  // All pixels outside are background; where nothing can be seen it is empty.
  Box foreground() const;

 private:
  struct Point {
    double x_px = 0, y_px = 0, depth = 0;
  };
  struct Body {  // a primitive in this view
    bool visible = false;
    bool everywhere = false;  // some of it is behind the camera: it can be in any tile
    bool flat = false;        // `plane` is exact enough to compare
    double nearest = 0;       // 1 / depth, nowhere exceeded
    InverseDepth plane;
  };
  struct Span {  // columns in pixels; empty where begin > end
    double begin = 0, end = 0;
  };
  struct RowRange {
    int begin = 0, end = 0;
  };

  std::size_t offset(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
  }
  void project(const SceneOutline& outline, const Camera& camera);
  Body body_of(const SceneOutline::Frame& frame, const Camera& camera) const;
  void claim(const SceneOutline& outline, const SceneOutline::Plate& plate);
  void cut_by_lines(const Point& a, const Point& b, std::size_t line_of_row);
  void claim_row(int row, const Span& inside, std::int32_t primitive);
  void contest(const SceneOutline& outline, std::int32_t primitive);
  RowRange clear_spans(double top_px, double bottom_px);
  void widen(const Point& a, const Point& b);
  void contest_row(int row, const Span& touched, std::int32_t primitive);

  int width_px_ = 0, height_px_ = 0;
  bool orthogonal_ = false;  // then no plane is `flat`: 1 / depth is no linear function there
  int columns_ = 0, rows_ = 0;
  int first_column_ = 0, end_column_ = 0, first_row_ = 0, end_row_ = 0;  // tiles that are touched
  std::vector<Point> points_;
  std::vector<Body> bodies_;
  std::vector<std::int32_t> owner_;
  std::vector<float> least_;  // the owner's 1 / depth is nowhere in the tile below this
  std::vector<Span> spans_;   // two a row of tiles: scratch of claim() and contest()
};

}  // namespace aspect
