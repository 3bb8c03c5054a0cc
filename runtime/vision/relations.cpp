#include "runtime/vision/relations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <tuple>

#include "runtime/base/portable_math.h"
#include "runtime/vision/vision_limits.h"

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

// The shortest first, or the most important; the two directions of a pair one after the other.
void sort_by_rank(std::span<const Contour> contours, RelationChoice choice,
                  std::span<Relation> arcs) {
  const auto rank = [&](const Relation& r) {
    const Contour &a = contours[r.from], &b = contours[r.to];
    const float length = squared_distance(a.centre_px, b.centre_px);
    return choice == RelationChoice::important ? length / std::min(a.area_px, b.area_px) : length;
  };
  std::sort(arcs.begin(), arcs.end(), [&](const Relation& p, const Relation& q) {
    const auto key = [&](const Relation& r) {
      return std::tuple(rank(r), std::min(r.from, r.to), std::max(r.from, r.to), r.from);
    };
    return key(p) < key(q);
  });
}

// Kruskal's minimal spanning tree of arcs sorted by length: brings its arcs, both directions, to
// the front and returns their number. O(contours * arcs), at most kMaxBlobContours contours.
std::size_t tree_arcs_first(std::size_t contour_count, std::span<Relation> arcs) {
  std::array<std::uint16_t, kMaxBlobContours> tree_of;
  std::iota(tree_of.begin(), tree_of.end(), std::uint16_t{0});
  std::size_t count = 0;
  for (std::size_t next = 0; next < arcs.size(); ++next) {
    const Relation arc = arcs[next];
    const bool way_back = count > 0 && arcs[count - 1].from == arc.to &&
                          arcs[count - 1].to == arc.from && count % 2 == 1;
    if (!way_back && tree_of[arc.from] == tree_of[arc.to]) continue;
    std::rotate(arcs.begin() + static_cast<std::ptrdiff_t>(count),
                arcs.begin() + static_cast<std::ptrdiff_t>(next),
                arcs.begin() + static_cast<std::ptrdiff_t>(next + 1));
    ++count;
    if (way_back) continue;
    std::replace(tree_of.begin(), tree_of.begin() + static_cast<std::ptrdiff_t>(contour_count),
                 std::uint16_t{tree_of[arc.from]}, std::uint16_t{tree_of[arc.to]});
  }
  return count;
}

}  // namespace

std::uint8_t direction_code(Point2 vector) {
  constexpr double kStep_rad = std::numbers::pi / 8;
  const double turns =
      portable_atan2(static_cast<double>(vector.y), static_cast<double>(vector.x)) / kStep_rad;
  return static_cast<std::uint8_t>(static_cast<int>(std::lround(turns)) & 15);
}

int direction_distance(std::uint8_t a, std::uint8_t b) {
  const int steps = std::abs(a - b);
  return std::min(steps, 16 - steps);
}

int relate(std::span<const Contour> contours, RelationChoice choice, int relations_max,
           std::span<Relation> out) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (std::size_t k = 0; k < contours.size() && count < out.size(); ++k) {
      if (i == k) continue;
      const Point2 a = contours[i].centre_px, b = contours[k].centre_px;
      out[count++] = {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(k),
                      direction_code({b.x - a.x, b.y - a.y}), kind_of(contours[i], contours[k])};
    }
  }
  const bool tree = choice == RelationChoice::tree;
  auto most = static_cast<std::size_t>(std::max(relations_max, 0));
  if (!tree && (most == 0 || count <= most)) return static_cast<int>(count);
  const auto arcs = out.first(count);
  sort_by_rank(contours, choice, arcs);
  if (tree) most = std::max(most, tree_arcs_first(contours.size(), arcs));
  const auto kept = arcs.first(std::min(most, count));
  std::sort(kept.begin(), kept.end(), [](const Relation& p, const Relation& q) {
    return std::tuple(p.from, p.to) < std::tuple(q.from, q.to);
  });
  return static_cast<int>(kept.size());
}

}  // namespace aspect
