#include "compiler/viewsphere/patch_division.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

using Point = Eigen::Vector2d;

// The flat triangle that stands for every patch: shares of area are the same in all triangles.
Point corner(std::size_t k) {
  return k % 3 == 0 ? Point(0, 0) : k % 3 == 1 ? Point(1, 0) : Point(0, 1);
}

Point point_at(double place) {
  const auto edge = static_cast<std::size_t>(std::min(std::floor(place), 2.0));
  const double share = place - static_cast<double>(edge);
  return (1 - share) * corner(edge) + share * corner(edge + 1);
}

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The middle of the places. Where all lie on one edge it would have no area on its inner side, so
// it is moved towards the middle of the patch.
Point middle(const PatchDivision& division) {
  Point sum(0, 0);
  for (const double place : division.places) sum += point_at(place);
  const Point mean = sum / static_cast<double>(division.places.size());
  const bool on_one_edge =
      std::floor(division.places.front()) == std::floor(division.places.back());
  return on_one_edge ? Point((mean + Point(1, 1) / 3) / 2) : mean;
}

// Where the ray from `from` through `to` leaves the triangle.
double exit_place(const Point& from, const Point& to) {
  const Point along = to - from;
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const Point side = corner(edge + 1) - corner(edge);
    const double below = cross(along, side);
    if (below <= 0) continue;  // a ray leaves counter-clockwise triangles with edges to its left
    const double distance = cross(corner(edge) - from, side) / below;
    if (distance >= least) continue;
    least = distance;
    const double share = cross(corner(edge) - from, along) / below;
    best = static_cast<double>(edge) + std::clamp(share, 0.0, 1.0);
  }
  return best >= 3 ? 0 : best;
}

}  // namespace

PatchDivision joined(const PatchDivision& along_edges) {
  PatchDivision division;
  const std::size_t count = along_edges.places.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (along_edges.classes[k] == along_edges.classes[(k + count - 1) % count]) continue;
    division.places.push_back(along_edges.places[k]);
    division.classes.push_back(along_edges.classes[k]);
  }
  if (division.places.empty()) return {{along_edges.places[0]}, {along_edges.classes[0]}};
  return division;
}

std::vector<double> piece_shares(const PatchDivision& division) {
  const std::size_t count = division.places.size();
  if (count < 2) return {1};
  const Point centre = middle(division);
  std::vector<double> shares;
  for (std::size_t k = 0; k < count; ++k) {
    const double begin = division.places[k];
    const double end = k + 1 < count ? division.places[k + 1] : division.places[0] + 3;
    Point at = point_at(begin) - centre;
    double twice_area = 0;
    const auto go_to = [&](double place) {
      const Point next = point_at(std::fmod(place, 3.0)) - centre;
      twice_area += cross(at, next);
      at = next;
    };
    for (double corner_place = std::floor(begin) + 1; corner_place < end; ++corner_place)
      go_to(corner_place);
    go_to(end);
    shares.push_back(twice_area);  // the whole triangle's is 1
  }
  return shares;
}

std::vector<DivisionTriangle> division_triangles(const PatchDivision& division) {
  const std::size_t count = division.places.size();
  std::vector<DivisionTriangle> triangles;
  for (std::size_t k = 0; k < count; ++k) {
    const double end = k + 1 < count ? division.places[k + 1] : division.places[0] + 3;
    for (double at = division.places[k]; at < end;) {
      const double to = std::min(std::floor(at) + 1, end);
      const double turns = at >= 3 ? 3 : 0;
      triangles.push_back({division.classes[k], at - turns, to - turns});
      at = to;
    }
  }
  return triangles;
}

Eigen::Vector3d division_middle(const PatchDivision& division) {
  const Point at = middle(division);
  return {1 - at.x() - at.y(), at.x(), at.y()};
}

std::int32_t class_at(const PatchDivision& division, const Eigen::Vector3d& barycentric) {
  if (division.places.size() < 2) return division.classes[0];
  const double place = exit_place(middle(division), {barycentric[1], barycentric[2]});
  const auto next = std::upper_bound(division.places.begin(), division.places.end(), place);
  const auto k = static_cast<std::size_t>(next - division.places.begin());
  return division.classes[(k + division.classes.size() - 1) % division.classes.size()];
}

std::int32_t SphereClasses::at(const ViewSphere& sphere, const Eigen::Vector3d& direction) const {
  const PatchId leaf = sphere.locate(direction);
  const auto division = divisions.find(static_cast<std::uint32_t>(leaf));
  if (division == divisions.end()) return class_of[static_cast<std::size_t>(leaf)];
  return class_at(division->second, barycentric(sphere, leaf, direction));
}

Eigen::Vector3d barycentric(const ViewSphere& sphere, PatchId patch,
                            const Eigen::Vector3d& direction) {
  Eigen::Matrix3d corners;
  for (std::size_t k = 0; k < 3; ++k)
    corners.col(static_cast<Eigen::Index>(k)) = sphere.position(sphere.patch(patch).corners[k]);
  const Eigen::Vector3d weights = corners.inverse() * direction;
  return weights / weights.sum();
}

}  // namespace aspect
