#include "compiler/scene/flat_piece.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kFlatness = 1e-7;         // of the size: what single-precision coordinates can say
constexpr std::size_t kMaxCorners = 1000;  // cutting it into triangles is quadratic in them

Vector3d doubled_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3d& a = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
}

// The normal of the largest triangle where all vertices lie in its plane; zero where not.
Vector3d common_normal(const Mesh& mesh) {
  Vector3d largest = Vector3d::Zero(), least = mesh.vertices[0], greatest = least;
  for (const auto& triangle : mesh.triangles) {
    const Vector3d area = doubled_area(mesh, triangle);
    if (area.squaredNorm() > largest.squaredNorm()) largest = area;
  }
  for (const Vector3d& vertex : mesh.vertices) {
    least = least.cwiseMin(vertex);
    greatest = greatest.cwiseMax(vertex);
  }
  const Vector3d normal = largest.normalized();
  const double most = kFlatness * (greatest - least).norm();
  for (const Vector3d& vertex : mesh.vertices)
    if (std::abs(normal.dot(vertex - mesh.vertices[0])) > most) return Vector3d::Zero();
  return normal;
}

using Neighbours = std::map<std::uint32_t, std::vector<std::uint32_t>>;

// By vertex, along the edges that one triangle alone has; empty where an edge has more than two.
Neighbours border_of(const Mesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> uses;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  Neighbours border;
  for (const auto& [edge, count] : uses) {
    if (count > 2) return {};
    if (count == 2) continue;
    border[edge[0]].push_back(edge[1]);
    border[edge[1]].push_back(edge[0]);
  }
  return border;
}

std::optional<Polygon> closed_line(const Mesh& mesh, const Neighbours& border) {
  Polygon polygon;
  const std::uint32_t first = border.begin()->first;
  std::uint32_t last = first, here = first;
  do {
    const std::vector<std::uint32_t>& next = border.at(here);
    if (next.size() != 2) return std::nullopt;
    polygon.vertices.push_back(mesh.vertices[here]);
    const std::uint32_t ahead = next[0] != last ? next[0] : next[1];
    last = here;
    here = ahead;
  } while (here != first);
  if (polygon.vertices.size() != border.size()) return std::nullopt;
  return polygon;
}

}  // namespace

std::optional<Polygon> as_polygon(const Mesh& mesh) {
  const Vector3d normal = common_normal(mesh);
  if (normal.isZero()) return std::nullopt;
  const Neighbours border = border_of(mesh);
  if (border.size() < 3 || border.size() > kMaxCorners) return std::nullopt;
  std::optional<Polygon> polygon = closed_line(mesh, border);
  if (!polygon) return std::nullopt;

  // Triangles that overlap have more area than what their border holds.
  double covered = 0, held = 0;
  for (const auto& triangle : mesh.triangles) covered += doubled_area(mesh, triangle).norm();
  for (std::size_t k = 2; k < polygon->vertices.size(); ++k) {
    const Vector3d& a = polygon->vertices[0];
    held += normal.dot((polygon->vertices[k - 1] - a).cross(polygon->vertices[k] - a));
  }
  if (std::abs(covered - std::abs(held)) > 1e-6 * covered) return std::nullopt;
  return polygon;
}

}  // namespace aspect
