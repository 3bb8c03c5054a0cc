#include "runtime/recognition/model_borders.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

// An edge as the picture shows it, if it may be a border.
struct ShownEdge {
  StraightPoint from, to;
  float length_px = 0;
  float normal_x = 0, normal_y = 0;  // away from the surface that the edge belongs to
  ColourClass inside = 0, outside = 0;
  bool parts_colours = false;  // both sides are known
  bool may_be_border = false;
};

float side_of(const StraightPoint& from, const StraightPoint& to, const StraightPoint& p) {
  return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

// Surfaces are seen from both sides and wound either way: whether two of them fold at an edge, or
// go on beyond it, shows in where the picture has their third corners.
ShownEdge shown(const ModelEdge& edge, std::span<const StraightPoint> points) {
  ShownEdge s;
  s.from = points[edge.ends[0]];
  s.to = points[edge.ends[1]];
  const float dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
  s.length_px = std::sqrt(dx * dx + dy * dy);
  constexpr float kLeastLength_px = 0.5F;
  if (!(s.length_px >= kLeastLength_px)) return s;
  const StraightPoint &p = points[edge.opposite[0]], &q = points[edge.opposite[1]];
  const float a = side_of(s.from, s.to, p), b = side_of(s.from, s.to, q);
  const bool folds = edge.opposite[0] == edge.opposite[1] || (a > 0) == (b > 0);
  if (!folds && edge.colours[0] == edge.colours[1]) return s;
  s.may_be_border = true;
  s.parts_colours = !folds;
  // Of two surfaces on one side, the one in front is seen: it rises faster towards the camera.
  std::size_t seen = 0;
  if (folds && edge.opposite[0] != edge.opposite[1]) {
    const auto rise = [&](const StraightPoint& corner, float side) {
      const float along =
          ((corner.x - s.from.x) * dx + (corner.y - s.from.y) * dy) / (s.length_px * s.length_px);
      const float foot = s.from.nearness + along * (s.to.nearness - s.from.nearness);
      return std::abs(side) > 0 ? (corner.nearness - foot) / std::abs(side) : 0;
    };
    if (rise(q, b) > rise(p, a)) seen = 1;
  }
  s.inside = edge.colours[seen];
  s.outside = folds ? kBackgroundClass : edge.colours[1 - seen];
  const float towards = (seen == 0 ? a : b) > 0 ? 1.0F : -1.0F;
  // side_of grows along (-dy, dx).
  s.normal_x = towards * dy / s.length_px;
  s.normal_y = -towards * dx / s.length_px;
  return s;
}

// What a point between the ends is in the picture and on the object, perspective considered.
struct EdgePoint {
  float x = 0, y = 0, nearness = 0;
  double share = 0;  // of the way on the object
};

EdgePoint between(const ShownEdge& edge, float share) {
  const float nearness = edge.from.nearness + share * (edge.to.nearness - edge.from.nearness);
  return {edge.from.x + share * (edge.to.x - edge.from.x),
          edge.from.y + share * (edge.to.y - edge.from.y), nearness,
          static_cast<double>(share * edge.to.nearness / nearness)};
}

class Finder {
 public:
  Finder(const ObjectModel& model, const ModelDrawing& drawing)
      : drawing_(drawing), slack_(0.04F * static_cast<float>(model.radius)) {}

  bool is_border(const ShownEdge& edge, const EdgePoint& p, ColourClass& outside) const {
    const float reach = 1.5F * drawing_.cell_px();
    const auto in = drawing_.at(p.x - reach * edge.normal_x, p.y - reach * edge.normal_y);
    const auto out = drawing_.at(p.x + reach * edge.normal_x, p.y + reach * edge.normal_y);
    const float nearest = p.nearness * (1 + slack_ * p.nearness);
    if (!in.covered || in.colour != edge.inside) return false;
    if (in.nearness > nearest || out.nearness > nearest) return false;
    if (in.nearness < p.nearness * (1 - 2 * slack_ * p.nearness)) return false;
    outside = out.colour;
    return edge.parts_colours ? outside == edge.outside : outside != edge.inside;
  }

 private:
  const ModelDrawing& drawing_;
  float slack_;
};

}  // namespace

std::size_t find_border_points(const ObjectModel& model, const ModelDrawing& drawing,
                               std::span<BorderPoint> points) {
  const Finder finder(model, drawing);
  float total_px = 0;
  for (const ModelEdge& edge : model.edges) {
    const ShownEdge s = shown(edge, drawing.points());
    if (s.may_be_border) total_px += s.length_px;
  }
  // Most models hide half of their edges or more.
  const float spacing_px =
      std::max(1.0F, 1.6F * total_px / (2.0F * static_cast<float>(points.size())));
  std::size_t count = 0;
  float next_px = spacing_px / 2;
  for (const ModelEdge& edge : model.edges) {
    const ShownEdge s = shown(edge, drawing.points());
    if (!s.may_be_border) continue;
    for (; next_px < s.length_px; next_px += spacing_px) {
      const EdgePoint p = between(s, next_px / s.length_px);
      ColourClass outside = kBackgroundClass;
      if (!finder.is_border(s, p, outside)) continue;
      if (count == points.size()) return count;
      const Vector3d &a = model.vertices[edge.ends[0]], &b = model.vertices[edge.ends[1]];
      points[count++] = {
          a + p.share * (b - a), p.x, p.y, s.normal_x, s.normal_y, s.inside, outside};
    }
    next_px -= s.length_px;
  }
  return count;
}

}  // namespace aspect
