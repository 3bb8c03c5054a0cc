#include "compiler/render/tile_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aspect {
namespace {

// Pixels by which a border may be off, here and in Embree's single precision: fifty times what the
// tests find.
constexpr double kMargin = 0.05;

// Depths closer to each other than this share of themselves are left to the rays.
constexpr double kDepthMargin = 1e-4;

// Nearer points count as behind the camera: their pictures are too far out to be computed with.
constexpr double kNearest = 1e-6;

// A plane steeper than this (the range of its 1 / depth over the picture, in units of the largest
// that occurs) is left to the rays; below, single precision keeps 2e-5 of it.
constexpr double kSteepest = 100;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kTile = TileMap::kTile;
constexpr double kLastPixel = kTile - 1;  // of a tile, counted from its first
constexpr double kMiddle = kLastPixel / 2;

int tiles_in(int pixels) {
  return (pixels + kTile - 1) / kTile;
}

int floor_within(double value, int low, int high) {
  return static_cast<int>(std::floor(std::clamp<double>(value, low, high)));
}

int ceil_within(double value, int low, int high) {
  return static_cast<int>(std::ceil(std::clamp<double>(value, low, high)));
}

}  // namespace

void TileMap::classify(const SceneOutline& outline, const Camera& camera) {
  width_px_ = camera.intrinsics.width_px;
  height_px_ = camera.intrinsics.height_px;
  orthogonal_ = camera.intrinsics.projection == Projection::kOrthogonal;
  columns_ = tiles_in(width_px_);
  rows_ = tiles_in(height_px_);
  first_column_ = columns_;
  first_row_ = rows_;
  end_column_ = end_row_ = 0;
  owner_.assign(offset(rows_), kNothing);
  least_.assign(offset(rows_), -std::numeric_limits<float>::infinity());
  spans_.resize(2 * static_cast<std::size_t>(rows_));

  project(outline, camera);
  for (const SceneOutline::Plate& plate : outline.plates) {
    const Body& body = bodies_[plate.primitive];
    if (body.visible && body.flat && !body.everywhere) claim(outline, plate);
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    if (bodies_[k].visible) contest(outline, static_cast<std::int32_t>(k));
}

Box TileMap::foreground() const {
  if (first_row_ >= end_row_) return {};
  const int x = first_column_ * kTile, y = first_row_ * kTile;
  return {x, y, std::min(end_column_ * kTile, width_px_) - x,
          std::min(end_row_ * kTile, height_px_) - y};
}

void TileMap::project(const SceneOutline& outline, const Camera& camera) {
  const Intrinsics& in = camera.intrinsics;
  points_.resize(outline.points.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Eigen::Vector3d point_camera =
        camera.camera_from_object * (outline.points[k] - camera.position_object);
    const double z = orthogonal_ ? 1 : std::max(point_camera.z(), kNearest);
    points_[k] = {in.cx_px + in.fx_px * point_camera.x() / z,
                  in.cy_px + in.fy_px * point_camera.y() / z, point_camera.z()};
  }
  bodies_.resize(outline.frames.size());
  for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k] = body_of(outline.frames[k], camera);
}

TileMap::Body TileMap::body_of(const SceneOutline::Frame& frame, const Camera& camera) const {
  double least_depth = kInfinity, greatest_depth = -kInfinity;
  for (std::uint32_t k = frame.first_point; k < frame.end_point; ++k) {
    least_depth = std::min(least_depth, points_[k].depth);
    greatest_depth = std::max(greatest_depth, points_[k].depth);
  }
  Body body;
  body.visible = greatest_depth > kNearest;
  if (orthogonal_) return body;
  body.everywhere = least_depth <= kNearest;
  body.nearest = body.everywhere ? kInfinity : 1 / least_depth;
  if (!frame.flat || body.everywhere) return body;

  // n . p = h in camera coordinates, p = depth * ((column - cx) / fx, (row - cy) / fy, 1).
  const Intrinsics& in = camera.intrinsics;
  const Eigen::Vector3d n = camera.camera_from_object * frame.normal;
  const double h = frame.normal.dot(frame.on_plane - camera.position_object);
  const double x = n.x() / (h * in.fx_px), y = n.y() / (h * in.fy_px);
  body.plane = {x, y, n.z() / h - x * in.cx_px - y * in.cy_px};
  const double range = std::abs(x) * in.width_px + std::abs(y) * in.height_px;
  body.flat = range + std::abs(body.plane.constant) < kSteepest * body.nearest;
  return body;
}

TileMap::RowRange TileMap::clear_spans(double top_px, double bottom_px) {
  const RowRange range = {ceil_within((top_px - kLastPixel - kMargin) / kTile, 0, rows_),
                          floor_within((bottom_px + kMargin) / kTile, -1, rows_ - 1) + 1};
  const Span empty = {kInfinity, -kInfinity};
  if (range.begin < range.end)
    std::fill(spans_.begin() + 2 * range.begin, spans_.begin() + 2 * range.end, empty);
  return range;
}

// A tile lies inside a convex polygon if its top and its bottom line do.
void TileMap::claim(const SceneOutline& outline, const SceneOutline::Plate& plate) {
  double top = kInfinity, bottom = -kInfinity;
  for (std::uint32_t k = plate.first_corner; k < plate.end_corner; ++k) {
    top = std::min(top, points_[outline.corners[k]].y_px);
    bottom = std::max(bottom, points_[outline.corners[k]].y_px);
  }
  const RowRange range = clear_spans(top, bottom);
  const Point* last = &points_[outline.corners[plate.end_corner - 1]];
  for (std::uint32_t k = plate.first_corner; k < plate.end_corner; ++k) {
    const Point* next = &points_[outline.corners[k]];
    cut_by_lines(*last, *next, 0);
    cut_by_lines(*last, *next, 1);
    last = next;
  }
  for (int row = range.begin; row < range.end; ++row) {
    const Span& above = spans_[2 * static_cast<std::size_t>(row)];
    const Span& below = spans_[2 * static_cast<std::size_t>(row) + 1];
    const Span inside = {std::max(above.begin, below.begin), std::min(above.end, below.end)};
    claim_row(row, inside, static_cast<std::int32_t>(plate.primitive));
  }
}

// Widens the spans of the lines just above (0) or just below (1) every row of tiles to the points
// where the edge a b cuts them.
void TileMap::cut_by_lines(const Point& a, const Point& b, std::size_t line_of_row) {
  const Point& upper = a.y_px < b.y_px ? a : b;
  const Point& lower = a.y_px < b.y_px ? b : a;
  if (upper.y_px == lower.y_px) return;
  const double first_line = line_of_row == 0 ? -kMargin : kLastPixel + kMargin;
  const int begin = ceil_within((upper.y_px - first_line) / kTile, 0, rows_);
  const int last = floor_within((lower.y_px - first_line) / kTile, -1, rows_ - 1);
  const double slope = (lower.x_px - upper.x_px) / (lower.y_px - upper.y_px);
  for (int row = begin; row <= last; ++row) {
    const double x = upper.x_px + slope * (row * kTile + first_line - upper.y_px);
    Span& span = spans_[2 * static_cast<std::size_t>(row) + line_of_row];
    span.begin = std::min(span.begin, x);
    span.end = std::max(span.end, x);
  }
}

void TileMap::claim_row(int row, const Span& inside, std::int32_t primitive) {
  const int begin = ceil_within((inside.begin + kMargin) / kTile, 0, columns_);
  const int end = floor_within((inside.end - kMargin - kLastPixel) / kTile, -1, columns_ - 1) + 1;
  if (begin >= end) return;
  const InverseDepth& plane = bodies_[static_cast<std::size_t>(primitive)].plane;
  const double spread = kMiddle * (std::abs(plane.x) + std::abs(plane.y));
  const auto first =
      static_cast<float>(plane.at(begin * kTile + kMiddle, row * kTile + kMiddle) - spread);
  const auto step = static_cast<float>(kTile * plane.x);
  std::int32_t* owner = owner_.data() + offset(row) + begin;
  float* least = least_.data() + offset(row) + begin;
  for (int k = 0; k < end - begin; ++k) {
    const float here = first + step * static_cast<float>(k);
    const bool nearer = here > least[k];
    owner[k] = nearer ? primitive : owner[k];
    least[k] = nearer ? here : least[k];
  }
}

void TileMap::contest(const SceneOutline& outline, std::int32_t primitive) {
  const SceneOutline::Frame& frame = outline.frames[static_cast<std::size_t>(primitive)];
  if (bodies_[static_cast<std::size_t>(primitive)].everywhere) {
    for (int row = 0; row < rows_; ++row) contest_row(row, {-kInfinity, kInfinity}, primitive);
    return;
  }
  double top = kInfinity, bottom = -kInfinity;
  for (std::uint32_t k = frame.first_point; k < frame.end_point; ++k) {
    top = std::min(top, points_[k].y_px);
    bottom = std::max(bottom, points_[k].y_px);
  }
  const RowRange range = clear_spans(top, bottom);
  for (std::uint32_t k = frame.first_edge; k < frame.end_edge; ++k)
    widen(points_[outline.edges[k].from], points_[outline.edges[k].to]);
  for (int row = range.begin; row < range.end; ++row)
    contest_row(row, spans_[2 * static_cast<std::size_t>(row)], primitive);
}

// Widens the span of every row of tiles by the part of the edge a b that lies in the row.
void TileMap::widen(const Point& a, const Point& b) {
  const Point& upper = a.y_px < b.y_px ? a : b;
  const Point& lower = a.y_px < b.y_px ? b : a;
  const int begin = ceil_within((upper.y_px - kLastPixel - kMargin) / kTile, 0, rows_);
  const int last = floor_within((lower.y_px + kMargin) / kTile, -1, rows_ - 1);
  const double height = lower.y_px - upper.y_px;
  const double slope = height > 0 ? (lower.x_px - upper.x_px) / height : 0;
  for (int row = begin; row <= last; ++row) {
    const double enters = row * kTile - kMargin, leaves = row * kTile + kLastPixel + kMargin;
    const double x0 =
        enters <= upper.y_px ? upper.x_px : upper.x_px + slope * (enters - upper.y_px);
    const double x1 =
        leaves >= lower.y_px ? lower.x_px : upper.x_px + slope * (leaves - upper.y_px);
    Span& span = spans_[2 * static_cast<std::size_t>(row)];
    span.begin = std::min({span.begin, x0, x1});
    span.end = std::max({span.end, x0, x1});
  }
}

void TileMap::contest_row(int row, const Span& touched, std::int32_t primitive) {
  const int begin = ceil_within((touched.begin - kMargin - kLastPixel) / kTile, 0, columns_);
  const int end = floor_within((touched.end + kMargin) / kTile, -1, columns_ - 1) + 1;
  if (begin >= end) return;
  first_column_ = std::min(first_column_, begin);
  end_column_ = std::max(end_column_, end);
  first_row_ = std::min(first_row_, row);
  end_row_ = std::max(end_row_, row + 1);

  const Body& body = bodies_[static_cast<std::size_t>(primitive)];
  const auto nearest = static_cast<float>(body.nearest * (1 + kDepthMargin));
  float first = nearest, step = 0;
  if (body.flat) {
    const double spread = kMiddle * (std::abs(body.plane.x) + std::abs(body.plane.y));
    first = static_cast<float>(body.plane.at(begin * kTile + kMiddle, row * kTile + kMiddle) +
                               spread + kDepthMargin * body.nearest);
    step = static_cast<float>(kTile * body.plane.x);
  }
  std::int32_t* owner = owner_.data() + offset(row) + begin;
  const float* least = least_.data() + offset(row) + begin;
  for (int k = 0; k < end - begin; ++k) {
    const float here = std::min(nearest, first + step * static_cast<float>(k));
    const bool withdrawn = (owner[k] != primitive) & (here >= least[k]);
    owner[k] = withdrawn ? kContested : owner[k];
  }
}

}  // namespace aspect
