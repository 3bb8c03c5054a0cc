// Aspects grow into the strips between them, patch by patch, until they meet.
#include "tools/report/aspect_neighbours.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace aspect {
namespace {

struct Grown {
  std::vector<std::int32_t> class_of;
  std::vector<int> steps;
};

Grown grown(const SphereMesh& mesh, const std::vector<MeshSide>& sides) {
  Grown now;
  for (const SpherePiece& piece : mesh.pieces) now.class_of.push_back(piece.class_id);
  now.steps.assign(mesh.pieces.size(), 0);
  for (int step = 1; 2 * step <= kWidestGap; ++step) {
    Grown next = now;
    const auto grow = [&](std::size_t from, std::size_t to) {
      if (now.class_of[from] == kNoClass || next.class_of[to] != kNoClass) return;
      next.class_of[to] = now.class_of[from];
      next.steps[to] = step;
    };
    for (const MeshSide& side : sides) {
      grow(side.left, side.right);
      grow(side.right, side.left);
    }
    now = std::move(next);
  }
  return now;
}

}  // namespace

std::vector<std::vector<AspectNeighbour>> aspect_neighbours(const SphereMesh& mesh,
                                                            std::size_t aspects) {
  const std::vector<MeshSide> sides = sides_of(mesh);
  const Grown all = grown(mesh, sides);
  struct Border {
    double touching_deg = 0, across_deg = 0;
    int least_gap = kWidestGap;
  };
  std::map<std::pair<std::int32_t, std::int32_t>, Border> borders;
  for (const MeshSide& side : sides) {
    const auto [a, b] = std::minmax(all.class_of[side.left], all.class_of[side.right]);
    if (a == b || a == kNoClass) continue;
    const int gap = all.steps[side.left] + all.steps[side.right];
    const double length_deg =
        2 * std::asin((mesh.points[side.from] - mesh.points[side.to]).norm() / 2) * 180 /
        std::numbers::pi;
    Border& border = borders[{a, b}];
    (gap == 0 ? border.touching_deg : border.across_deg) += length_deg;
    border.least_gap = std::min(border.least_gap, gap);
  }
  std::vector<std::vector<AspectNeighbour>> neighbours(aspects);
  for (const auto& [pair, border] : borders) {
    const double length = border.least_gap == 0 ? border.touching_deg : border.across_deg;
    if (border.least_gap > 0 && length < kLeastAcross_deg) continue;
    neighbours[static_cast<std::size_t>(pair.first)].push_back(
        {pair.second, length, border.least_gap});
    neighbours[static_cast<std::size_t>(pair.second)].push_back(
        {pair.first, length, border.least_gap});
  }
  for (auto& list : neighbours)
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
      if ((a.gap == 0) != (b.gap == 0)) return a.gap == 0;
      return a.border_deg > b.border_deg;
    });
  return neighbours;
}

}  // namespace aspect
