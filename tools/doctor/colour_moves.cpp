#include "tools/doctor/colour_moves.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "compiler/aspects/colour_separation.h"
#include "tools/doctor/colour_checks.h"

namespace aspect {
namespace {

using Eigen::Vector3d;
using Pair = std::pair<std::size_t, std::size_t>;

constexpr double kTarget = 1.25;  // steps: what rounding to bytes takes away is far less
constexpr double kStep = 0.5 / 255;

std::vector<Vector3d> directions() {
  std::vector<Vector3d> all;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back(Vector3d(x, y, z).normalized());
  std::vector<Vector3d> distinct;
  for (const Vector3d& direction : all)
    if (std::none_of(distinct.begin(), distinct.end(),
                     [&](const Vector3d& other) { return other.isApprox(direction); }))
      distinct.push_back(direction);
  return distinct;
}

void shift(Surface& surface, const Vector3d& by) {
  surface.diffuse += by;
  surface.ambient = (surface.ambient + by).cwiseMax(0).cwiseMin(1);
}

class Separation {
 public:
  Separation(Scene& scene, ColourGroups groups, const Sight& sight, const VisionParameters& vision)
      : scene_(scene), groups_(std::move(groups)), vision_(vision) {
    for (const auto& [pair, border] : sight.borders) touching_.insert(pair);
  }

  std::vector<ColourMove> run() {
    std::vector<ColourMove> moves;
    while (const std::optional<Pair> pair = worst_pair()) {
      const std::optional<Shift> first = nearest(pair->first), second = nearest(pair->second);
      if (!first && !second) {
        given_up_.insert(*pair);
        continue;
      }
      const bool move_first = first && (!second || first->length < second->length);
      moves.push_back(
          apply(move_first ? pair->first : pair->second, move_first ? *first : *second));
    }
    return moves;
  }

 private:
  struct Shift {
    Vector3d by;
    double length;
  };

  bool is_dark(const ColourGroups::Group& group) const {
    return is_background(group.seen, vision_);
  }

  std::optional<Pair> worst_pair() const {
    std::optional<Pair> worst;
    double least = 1;
    for (const Pair& pair : touching_) {
      const auto &a = groups_.groups[pair.first], &b = groups_.groups[pair.second];
      if (given_up_.contains(pair) || !is_inseparable(a, b, vision_)) continue;
      const double separation = colour_separation(a.seen, b.seen, vision_);
      if (worst && separation >= least) continue;
      worst = pair;
      least = separation;
    }
    return worst;
  }

  // From the colours that the group touches.
  double least_separation(std::size_t group, const Vector3d& seen) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Pair& pair : touching_) {
      if (pair.first != group && pair.second != group) continue;
      const auto& other = groups_.groups[pair.first == group ? pair.second : pair.first];
      if (!is_dark(other)) least = std::min(least, colour_separation(seen, other.seen, vision_));
    }
    return least;
  }

  std::optional<Shift> nearest(std::size_t group) const {
    static const std::vector<Vector3d> kDirections = directions();
    const Surface& surface = scene_.surfaces[groups_.groups[group].surfaces.front()];
    std::optional<Shift> best;
    for (const Vector3d& direction : kDirections) {
      for (double length = kStep; !best || length < best->length; length += kStep) {
        Surface moved = surface;
        shift(moved, length * direction);
        if (moved.diffuse.minCoeff() < 0 || moved.diffuse.maxCoeff() > 1) break;
        if (least_separation(group, colour_seen(scene_, moved)) < kTarget) continue;
        best = {length * direction, length};
        break;
      }
    }
    return best;
  }

  ColourMove apply(std::size_t group, const Shift& shifted) {
    ColourGroups::Group& moved = groups_.groups[group];
    Surface& first = scene_.surfaces[moved.surfaces.front()];
    ColourMove move{first.diffuse, {}, least_separation(group, moved.seen), 0};
    for (const std::size_t surface : moved.surfaces) shift(scene_.surfaces[surface], shifted.by);
    moved.seen = colour_seen(scene_, first);
    move.after = first.diffuse;
    move.separation_after = least_separation(group, moved.seen);
    return move;
  }

  Scene& scene_;
  ColourGroups groups_;
  const VisionParameters& vision_;
  std::set<Pair> touching_, given_up_;
};

}  // namespace

std::vector<ColourMove> separate_colours(Scene& scene, ColourGroups groups, const Sight& sight,
                                         const VisionParameters& vision) {
  return Separation(scene, std::move(groups), sight, vision).run();
}

}  // namespace aspect
