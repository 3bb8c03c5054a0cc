#include "runtime/vision/relations.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace aspect {
namespace {

// Centres this close have no direction that the pixel grid would not decide.
constexpr float kSuperimposed_px = 2.0F;

float squared_distance(Point2 a, Point2 b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

// A region surrounds what is in any of its holes, a hole only what it holds itself.
bool surrounds(const Contour& outer, const Contour& inner) {
  if (inner.inside != outer.region) return false;
  if (outer.external) return true;
  const Box &a = outer.box, &b = inner.box;
  return inner.external && a.x <= b.x && a.y <= b.y && b.x + b.width <= a.x + a.width &&
         b.y + b.height <= a.y + a.height;
}

Relation::Kind kind_of(const Contour& from, const Contour& to) {
  if (squared_distance(from.centre_px, to.centre_px) < kSuperimposed_px * kSuperimposed_px)
    return Relation::Kind::superimposed;
  if (surrounds(to, from)) return Relation::Kind::inside;
  if (surrounds(from, to)) return Relation::Kind::outside;
  return Relation::Kind::apart;
}

}  // namespace

std::uint8_t direction_code(Point2 vector) {
  constexpr float kStep_rad = 0.39269908F;
  const float turns = std::atan2(vector.y, vector.x) / kStep_rad;
  return static_cast<std::uint8_t>(static_cast<int>(std::lround(turns)) & 15);
}

int direction_distance(std::uint8_t a, std::uint8_t b) {
  const int steps = std::abs(a - b);
  return std::min(steps, 16 - steps);
}

int relate(std::span<const Contour> contours, int relations_max, std::span<Relation> out) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (std::size_t k = 0; k < contours.size() && count < out.size(); ++k) {
      if (i == k) continue;
      const Point2 a = contours[i].centre_px, b = contours[k].centre_px;
      out[count++] = {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(k),
                      direction_code({b.x - a.x, b.y - a.y}), kind_of(contours[i], contours[k])};
    }
  }
  if (relations_max <= 0 || count <= static_cast<std::size_t>(relations_max))
    return static_cast<int>(count);
  const auto arcs = out.first(count);
  std::sort(arcs.begin(), arcs.end(), [&](const Relation& p, const Relation& q) {
    const auto length = [&](const Relation& r) {
      return squared_distance(contours[r.from].centre_px, contours[r.to].centre_px);
    };
    return std::tuple(length(p), p.from, p.to) < std::tuple(length(q), q.from, q.to);
  });
  const auto kept = arcs.first(static_cast<std::size_t>(relations_max));
  std::sort(kept.begin(), kept.end(), [](const Relation& p, const Relation& q) {
    return std::tuple(p.from, p.to) < std::tuple(q.from, q.to);
  });
  return relations_max;
}

}  // namespace aspect
