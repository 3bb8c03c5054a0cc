// Pieces are cut at the rim; what two pieces of one class share cancels out, and what is left is
// chained into loops.
#include "tools/report/sphere_outlines.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace aspect {
namespace {

class HalfSphere {
 public:
  HalfSphere(const SphereMesh& mesh, const LookFrame& frame)
      : mesh_(mesh), frame_(frame), points_(mesh.points) {
    for (const Eigen::Vector3d& point : points_) depth_.push_back(point.dot(frame.towards));
  }

  // The part of the piece that is seen: fewer than three points where it is none.
  std::vector<PointId> seen_of(const SpherePiece& piece) {
    const std::vector<PointId> rim = mesh_.rim(piece);
    const auto is_seen = [&](PointId point) { return depth_[point] >= 0; };
    if (std::all_of(rim.begin(), rim.end(), is_seen)) return rim;
    // A side on the rim is not enough.
    if (std::none_of(rim.begin(), rim.end(), [&](PointId point) { return depth_[point] > 0; }))
      return {};
    std::vector<PointId> seen;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const PointId at = rim[k], next = rim[(k + 1) % rim.size()];
      if (is_seen(at)) seen.push_back(at);
      // Where one end lies on the rim itself nothing is cut.
      if (depth_[at] * depth_[next] < 0) seen.push_back(crossing(at, next));
    }
    return seen;
  }

  Eigen::Vector2d operator[](PointId point) const { return frame_(points_[point]); }

 private:
  PointId crossing(PointId a, PointId b) {
    if (a > b) std::swap(a, b);
    const auto [found, is_new] =
        crossings_.try_emplace(pair_of(a, b), static_cast<PointId>(points_.size()));
    if (is_new) {
      points_.push_back((points_[a] * depth_[b] - points_[b] * depth_[a]).normalized() *
                        (depth_[b] > depth_[a] ? 1 : -1));
      depth_.push_back(0);
    }
    return found->second;
  }

  const SphereMesh& mesh_;
  const LookFrame& frame_;
  std::vector<Eigen::Vector3d> points_;  // the mesh's, then crossings
  std::vector<double> depth_;
  std::unordered_map<std::uint64_t, PointId> crossings_;
};

// Directed sides, of which a side and its reverse cancel out.
class Sides {
 public:
  void add(PointId from, PointId to) {
    if (from == to) return;
    if (const auto reverse = next_.find(to); reverse != next_.end()) {
      auto& ends = reverse->second;
      if (const auto found = std::find(ends.begin(), ends.end(), from); found != ends.end()) {
        ends.erase(found);
        return;
      }
    }
    next_[from].push_back(to);
  }

  std::vector<std::vector<PointId>> loops() {
    std::vector<std::vector<PointId>> found;
    for (auto& [start, ends] : next_) {
      while (!ends.empty()) {
        std::vector<PointId>& loop = found.emplace_back();
        for (PointId at = start; !next_[at].empty();) {
          loop.push_back(at);
          const PointId next = next_[at].back();
          next_[at].pop_back();
          at = next;
          if (at == start) break;
        }
      }
    }
    return found;
  }

 private:
  std::map<PointId, std::vector<PointId>> next_;
};

}  // namespace

std::map<std::int32_t, std::vector<Outline>> class_outlines(const SphereMesh& mesh,
                                                            const LookFrame& frame) {
  HalfSphere half(mesh, frame);
  std::map<std::int32_t, Sides> sides;
  for (const SpherePiece& piece : mesh.pieces) {
    const std::vector<PointId> seen = half.seen_of(piece);
    if (seen.size() < 3) continue;
    for (std::size_t k = 0; k < seen.size(); ++k)
      sides[piece.class_id].add(seen[k], seen[(k + 1) % seen.size()]);
  }
  std::map<std::int32_t, std::vector<Outline>> outlines;
  for (auto& [class_id, own] : sides) {
    for (const std::vector<PointId>& loop : own.loops()) {
      Outline& outline = outlines[class_id].emplace_back();
      for (const PointId point : loop) outline.push_back(half[point]);
    }
  }
  return outlines;
}

std::vector<std::array<Eigen::Vector2d, 2>> patch_sides(const SphereMesh& mesh,
                                                        const LookFrame& frame) {
  HalfSphere half(mesh, frame);
  std::unordered_set<std::uint64_t> known;
  std::vector<std::array<Eigen::Vector2d, 2>> sides;
  for (const SpherePiece& piece : mesh.pieces) {
    const std::vector<PointId> seen = half.seen_of(piece);
    for (std::size_t k = 0; seen.size() > 2 && k < seen.size(); ++k) {
      const PointId from = seen[k], to = seen[(k + 1) % seen.size()];
      if (known.insert(pair_of(from, to)).second) sides.push_back({half[from], half[to]});
    }
  }
  return sides;
}

double area_of(const Outline& outline) {
  double twice = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Eigen::Vector2d &a = outline[k], &b = outline[(k + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

}  // namespace aspect
