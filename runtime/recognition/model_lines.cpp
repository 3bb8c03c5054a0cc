#include "runtime/recognition/model_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace aspect {
namespace {

struct ScreenPoint {
  double x = 0, y = 0;  // in the straight picture
  double nearness = 0;  // 1 / depth, linear in the picture
};

constexpr double kNearest = 1e-6;

std::optional<ScreenPoint> screen_point(const Vector3d& p, const CameraModel& camera) {
  if (!(p[2] > kNearest)) return std::nullopt;
  return ScreenPoint{camera.cx_px + camera.fx_px * p[0] / p[2],
                     camera.cy_px + camera.fy_px * p[1] / p[2], 1 / p[2]};
}

// What the frame shows, with a margin: lines beyond it are not worth following.
struct Window {
  double left = 0, top = 0, right = 0, bottom = 0;

  Window(int width_px, int height_px)
      : left(-0.5 * width_px),
        top(-0.5 * height_px),
        right(1.5 * width_px),
        bottom(1.5 * height_px) {}
  bool holds(const ScreenPoint& p) const {
    return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom;
  }
};

// Far from the centre a lens polynomial turns back, and would show what is outside within.
std::optional<Point2d> on_frame(const ScreenPoint& p, const Window& window,
                                const CameraModel& camera) {
  if (!window.holds(p)) return std::nullopt;
  const Point2d bent = camera.bent({p.x, p.y});
  const Point2d back = camera.straight(bent);
  if (!(std::hypot(back.x - p.x, back.y - p.y) < 1)) return std::nullopt;
  return bent;
}

// How near the nearest surface is, for each pixel of the straight picture.
class Surfaces {
 public:
  Surfaces(const ObjectModel& model, const std::vector<std::optional<ScreenPoint>>& points,
           const Window& window)
      : left_(window.right), top_(window.bottom) {
    double right = window.left, bottom = window.top;
    for (const auto& p : points) {
      if (!p) continue;
      left_ = std::min(left_, p->x - 1);
      top_ = std::min(top_, p->y - 1);
      right = std::max(right, p->x + 2);
      bottom = std::max(bottom, p->y + 2);
    }
    left_ = std::floor(std::max(left_, window.left));
    top_ = std::floor(std::max(top_, window.top));
    width_ = std::max(0, static_cast<int>(std::min(right, window.right) - left_) + 1);
    height_ = std::max(0, static_cast<int>(std::min(bottom, window.bottom) - top_) + 1);
    nearness_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
    for (const ModelTriangle& t : model.triangles) {
      const auto &a = points[t.corners[0]], &b = points[t.corners[1]], &c = points[t.corners[2]];
      if (a && b && c) fill(*a, *b, *c);
    }
  }

  // Whether a surface lies before the point by more than `slack`, a share of its distance. A point
  // on a rim is seen, so that the farthest of the pixels around it counts.
  bool hide(const ScreenPoint& p, double slack) const {
    const int x = static_cast<int>(std::lround(p.x - left_)),
              y = static_cast<int>(std::lround(p.y - top_));
    double farthest = at(x, y);
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) farthest = std::min(farthest, at(x + i, y + j));
    return farthest > p.nearness * (1 + slack);
  }

 private:
  double at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0;
    return nearness_[place(x, y)];
  }
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  void fill(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (std::abs(area) < 1e-9) return;
    const auto within = [](double pixel, int count) {
      return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(count)));
    };
    const int first_x = within(std::ceil(std::min({a.x, b.x, c.x}) - left_), width_),
              last_x = within(std::floor(std::max({a.x, b.x, c.x}) - left_), width_),
              first_y = within(std::ceil(std::min({a.y, b.y, c.y}) - top_), height_),
              last_y = within(std::floor(std::max({a.y, b.y, c.y}) - top_), height_);
    for (int y = std::max(0, first_y); y <= std::min(last_y, height_ - 1); ++y)
      for (int x = std::max(0, first_x); x <= std::min(last_x, width_ - 1); ++x) {
        const double dx = x + left_ - a.x, dy = y + top_ - a.y;
        const double u = (dx * (c.y - a.y) - dy * (c.x - a.x)) / area;
        const double v = (dy * (b.x - a.x) - dx * (b.y - a.y)) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        double& nearest = nearness_[place(x, y)];
        nearest = std::max(
            nearest, a.nearness + u * (b.nearness - a.nearness) + v * (c.nearness - a.nearness));
      }
  }

  double left_, top_;
  int width_ = 0, height_ = 0;
  std::vector<double> nearness_;
};

// `is_seen` says which points of the line are drawn.
template <typename IsSeen>
void add_pieces(const ScreenPoint& from, const ScreenPoint& to, const Window& window,
                const CameraModel& camera, IsSeen is_seen, std::vector<PictureLine>& pieces) {
  constexpr double kStep_px = 2, kMostSteps = 4000;
  const double length_px = std::hypot(to.x - from.x, to.y - from.y);
  const int steps = static_cast<int>(std::clamp(length_px / kStep_px, 1.0, kMostSteps));
  PictureLine piece;
  const auto finish = [&] {
    if (piece.size() > 1) pieces.push_back(piece);
    piece.clear();
  };
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const ScreenPoint p{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                        from.nearness + share * (to.nearness - from.nearness)};
    const std::optional<Point2d> point = on_frame(p, window, camera);
    if (point && is_seen(p))
      piece.push_back(*point);
    else
      finish();
  }
  finish();
}

// Of the triangles on both sides of an edge, outwards of the one where it is inwards of the other.
struct Sides {
  Vector3d first, second;
};

Sides sides_of(const Vector3d& a, const Vector3d& b, const Vector3d& beside_first,
               const Vector3d& beside_second) {
  return {cross(b - a, beside_first - a), cross(beside_second - a, b - a)};
}

// One side is seen from the front, the other from behind.
bool is_outline(const ObjectModel& model, const ModelEdge& edge, const RigidPose& pose) {
  const Vector3d a = pose(model.vertices[edge.ends[0]]), b = pose(model.vertices[edge.ends[1]]);
  const Sides sides = sides_of(a, b, pose(model.vertices[edge.opposite[0]]),
                               pose(model.vertices[edge.opposite[1]]));
  return (dot(sides.first, a) < 0) != (dot(sides.second, a) < 0);
}

}  // namespace

bool is_smooth(const ObjectModel& model, const ModelEdge& edge) {
  if (edge.opposite[0] == edge.opposite[1] || edge.colours[0] != edge.colours[1]) return false;
  const Sides sides = sides_of(model.vertices[edge.ends[0]], model.vertices[edge.ends[1]],
                               model.vertices[edge.opposite[0]], model.vertices[edge.opposite[1]]);
  constexpr double kLeastCosine = 0.819;  // of 35 degrees: of ten facets round a cylinder, and more
  return dot(sides.first, sides.second) > kLeastCosine * norm(sides.first) * norm(sides.second);
}

std::vector<PictureLine> line_through(const Vector3d& from, const Vector3d& to,
                                      const CameraModel& camera, int width_px, int height_px) {
  std::vector<PictureLine> pieces;
  const auto a = screen_point(from, camera), b = screen_point(to, camera);
  if (a && b)
    add_pieces(
        *a, *b, Window(width_px, height_px), camera, [](const ScreenPoint&) { return true; },
        pieces);
  return pieces;
}

std::vector<PictureLine> edges_seen(const ObjectModel& model, const RigidPose& pose,
                                    const CameraModel& camera, int width_px, int height_px) {
  std::vector<std::optional<ScreenPoint>> points;
  points.reserve(model.vertices.size());
  for (const Vector3d& vertex : model.vertices)
    points.push_back(screen_point(pose(vertex), camera));
  const Window window(width_px, height_px);
  const Surfaces surfaces(model, points, window);
  constexpr double kSlack = 0.01;  // of the radius
  std::vector<PictureLine> pieces;
  for (const ModelEdge& edge : model.edges) {
    const auto &a = points[edge.ends[0]], &b = points[edge.ends[1]];
    if (!a || !b || (is_smooth(model, edge) && !is_outline(model, edge, pose))) continue;
    const auto is_seen = [&](const ScreenPoint& p) {
      return !surfaces.hide(p, kSlack * model.radius * p.nearness);
    };
    add_pieces(*a, *b, window, camera, is_seen, pieces);
  }
  return pieces;
}

}  // namespace aspect
