#include "compiler/index/surface_simplification.h"

#include <meshoptimizer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace aspect {
namespace {

// Of the nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
double distance_to(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.norm();
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.norm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).norm();
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.norm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).norm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).norm();
  const Eigen::Vector3d normal = ab.cross(ac);
  return std::abs(ap.dot(normal)) / normal.norm();
}

double error_of(const ColouredSurface& simple, const ColouredSurface& surface) {
  constexpr std::size_t kSamples = 3000;
  const std::size_t step = std::max<std::size_t>(1, surface.points.size() / kSamples);
  double most = 0;
  for (std::size_t k = 0; k < surface.points.size(); k += step) {
    double nearest = 1e300;
    for (const ColouredTriangle& t : simple.triangles)
      nearest =
          std::min(nearest, distance_to(surface.points[k], simple.points[t.corners[0]],
                                        simple.points[t.corners[1]], simple.points[t.corners[2]]));
    most = std::max(most, nearest);
  }
  return most;
}

// The simplifier keeps seams: points in one place that are not the same. Each colour has its own.
struct Seamed {
  std::vector<float> places;         // three a point
  std::vector<std::uint32_t> point;  // of the surface
  std::vector<std::uint16_t> paint;
  std::vector<unsigned int> corners;  // three a triangle
};

Seamed seamed(const ColouredSurface& surface) {
  Seamed s;
  std::map<std::pair<std::uint32_t, std::uint16_t>, unsigned int> known;
  for (const ColouredTriangle& t : surface.triangles)
    for (const std::uint32_t corner : t.corners) {
      const auto [found, is_new] =
          known.try_emplace({corner, t.paint}, static_cast<unsigned int>(s.point.size()));
      if (is_new) {
        s.point.push_back(corner);
        s.paint.push_back(t.paint);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          s.places.push_back(static_cast<float>(surface.points[corner][axis]));
      }
      s.corners.push_back(found->second);
    }
  return s;
}

}  // namespace

SimplifiedSurface simplified_surface(const ColouredSurface& surface, std::size_t enough,
                                     double error) {
  const Seamed s = seamed(surface);
  const double scale = static_cast<double>(
      meshopt_simplifyScale(s.places.data(), s.point.size(), 3 * sizeof(float)));
  std::vector<unsigned int> corners = s.corners;
  std::size_t count = s.corners.size();
  constexpr int kDoublings = 6;
  for (int k = 0; k < kDoublings && count > 3 * enough; ++k, error *= 2)
    count = meshopt_simplify(corners.data(), s.corners.data(), s.corners.size(), s.places.data(),
                             s.point.size(), 3 * sizeof(float), 3 * enough / 2,
                             static_cast<float>(error / std::max(scale, 1e-12)), 0, nullptr);
  SimplifiedSurface simplified;
  simplified.surface.points = surface.points;
  for (std::size_t k = 0; k + 2 < count; k += 3)
    simplified.surface.triangles.push_back(
        {{s.point[corners[k]], s.point[corners[k + 1]], s.point[corners[k + 2]]},
         s.paint[corners[k]]});
  simplified.error = error_of(simplified.surface, surface);
  return simplified;
}

}  // namespace aspect
