// Ear clipping (Meisters 1975). Idea: a corner whose triangle with its two neighbours holds no
// other vertex can be cut off. Steps: drop the coordinate along which the normal is longest (the
// others stay exact, so shared edges do), mark all ears, cut the best-shaped one, look again at its
// two neighbours, repeat. Weak side: O(n^2), and a polygon that cuts itself has no right answer:
// where no ear is left, the smallest corner goes, so that the end is reached always.
#include "compiler/scene/ear_clipping.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace aspect {
namespace {

using Point = Eigen::Vector2d;

constexpr double kNoEar = -1;

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double doubled_area(const Point& a, const Point& b, const Point& c) {
  return cross(b - a, c - a);
}

// Counter-clockwise in the plane where the normal is longest.
std::vector<Point> flattened(std::span<const Eigen::Vector3d> vertices,
                             const Eigen::Vector3d& normal) {
  Eigen::Index dropped = 0;
  normal.cwiseAbs().maxCoeff(&dropped);
  Eigen::Index first = (dropped + 1) % 3, second = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(first, second);

  std::vector<Point> points;
  points.reserve(vertices.size());
  for (const Eigen::Vector3d& vertex : vertices) points.emplace_back(vertex[first], vertex[second]);
  return points;
}

// Relative to the polygon's size: below it a corner counts as straight.
double straight_area(const std::vector<Point>& points) {
  double reach = 0;
  for (const Point& point : points)
    reach = std::max(reach, (point - points.front()).cwiseAbs().maxCoeff());
  return 1e-14 * reach * reach;
}

class Clipper {
 public:
  explicit Clipper(std::vector<Point> points)
      : points_(std::move(points)),
        straight_(straight_area(points_)),
        ring_(points_.size()),
        quality_(points_.size(), kNoEar) {
    std::iota(ring_.begin(), ring_.end(), 0u);
    for (std::size_t k = 0; k < ring_.size(); ++k) quality_[ring_[k]] = ear_quality(k);
  }

  std::vector<Triangle> run() {
    std::vector<Triangle> triangles;
    while (ring_.size() >= 3) {
      const std::size_t ear = best_ear();
      const Triangle triangle = {before(ear), ring_[ear], after(ear)};
      if (area_at(ear) > straight_) triangles.push_back(triangle);
      cut(ear);
    }
    return triangles;
  }

 private:
  std::uint32_t before(std::size_t k) const { return ring_[(k + ring_.size() - 1) % ring_.size()]; }
  std::uint32_t after(std::size_t k) const { return ring_[(k + 1) % ring_.size()]; }
  double area_at(std::size_t k) const {
    return doubled_area(points_[before(k)], points_[ring_[k]], points_[after(k)]);
  }

  // Area over the square of the longest side: slivers last.
  double ear_quality(std::size_t k) const {
    const double area = area_at(k);
    if (area <= straight_ || blocked(k)) return kNoEar;
    const Point a = points_[before(k)], b = points_[ring_[k]], c = points_[after(k)];
    return area / std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  }

  // By any vertex inside; those that repeat one of the three corners are allowed.
  bool blocked(std::size_t k) const {
    const Point a = points_[before(k)], b = points_[ring_[k]], c = points_[after(k)];
    return std::any_of(ring_.begin(), ring_.end(), [&](std::uint32_t other) {
      const Point& point = points_[other];
      return point != a && point != b && point != c && doubled_area(a, b, point) >= 0 &&
             doubled_area(b, c, point) >= 0 && doubled_area(c, a, point) >= 0;
    });
  }

  std::size_t best_ear() const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < ring_.size(); ++k)
      if (quality_[ring_[k]] > quality_[ring_[best]]) best = k;
    return quality_[ring_[best]] > kNoEar ? best : least_corner();
  }

  // Straight corners and spikes first: to drop one changes no area.
  std::size_t least_corner() const {
    std::size_t least = 0;
    for (std::size_t k = 1; k < ring_.size(); ++k)
      if (std::abs(area_at(k)) < std::abs(area_at(least))) least = k;
    return least;
  }

  void cut(std::size_t ear) {
    const bool was_ear = quality_[ring_[ear]] > kNoEar;
    ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(ear));
    if (ring_.size() < 3) return;
    if (!was_ear) {
      for (std::size_t k = 0; k < ring_.size(); ++k) quality_[ring_[k]] = ear_quality(k);
      return;
    }
    for (const std::size_t k : {ear % ring_.size(), (ear + ring_.size() - 1) % ring_.size()})
      quality_[ring_[k]] = ear_quality(k);
  }

  std::vector<Point> points_;
  double straight_;
  std::vector<std::uint32_t> ring_;  // what is left, as indices of points_
  std::vector<double> quality_;      // by point
};

}  // namespace

Eigen::Vector3d polygon_normal(std::span<const Eigen::Vector3d> vertices) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double reach = 0;
  for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
    const Eigen::Vector3d from = vertices[k] - vertices[0], to = vertices[k + 1] - vertices[0];
    sum += from.cross(to);
    reach = std::max({reach, from.squaredNorm(), to.squaredNorm()});
  }
  const double length = sum.norm();
  if (length <= 1e-14 * reach) return Eigen::Vector3d::Zero();
  return sum / length;
}

bool is_convex(std::span<const Eigen::Vector3d> vertices) {
  const Eigen::Vector3d normal = polygon_normal(vertices);
  if (normal.isZero()) return false;
  const std::vector<Point> points = flattened(vertices, normal);
  const double straight = straight_area(points);

  // A star that winds twice turns the same way everywhere, but its x direction changes four times.
  int changes = 0;
  double last_x = 0, first_x = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point& a = points[k];
    const Point& b = points[(k + 1) % points.size()];
    const Point& c = points[(k + 2) % points.size()];
    if (doubled_area(a, b, c) < -straight) return false;
    const double x = b.x() - a.x();
    if (x == 0) continue;
    if (first_x == 0) first_x = x;
    if (last_x * x < 0) ++changes;
    last_x = x;
  }
  if (last_x * first_x < 0) ++changes;
  return changes <= 2;
}

std::vector<Triangle> triangulate(std::span<const Eigen::Vector3d> vertices) {
  const Eigen::Vector3d normal = polygon_normal(vertices);
  if (vertices.size() < 3 || normal.isZero()) return {};
  return Clipper(flattened(vertices, normal)).run();
}

}  // namespace aspect
