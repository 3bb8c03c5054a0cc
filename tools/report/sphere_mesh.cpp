#include "tools/report/sphere_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>

namespace aspect {
namespace {

class MeshOfSphere {
 public:
  MeshOfSphere(const ViewSphere& sphere, const SphereClasses& classes)
      : sphere_(sphere), classes_(classes) {}

  SphereMesh run() {
    for (std::uint32_t k = 0; k < sphere_.vertex_count(); ++k)
      mesh_.points.push_back(sphere_.position(VertexId{k}));
    for (std::uint32_t k = 0; k < sphere_.patch_count(); ++k) note_middles(PatchId{k});
    for (const PatchId leaf : sphere_.leaves()) {
      const auto division = classes_.divisions.find(static_cast<std::uint32_t>(leaf));
      if (division == classes_.divisions.end())
        mesh_.pieces.push_back({corners_of(leaf), classes_.class_of[number(leaf)]});
      else
        add_division(leaf, division->second);
    }
    return std::move(mesh_);
  }

 private:
  std::array<PointId, 3> corners_of(PatchId patch) const {
    std::array<PointId, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = static_cast<PointId>(sphere_.patch(patch).corners[k]);
    return corners;
  }

  void note_middles(PatchId id) {
    const Patch& patch = sphere_.patch(id);
    if (!patch.split) return;
    const std::array<PointId, 3> corners = corners_of(id), middles = corners_of(patch.children[3]);
    for (std::size_t k = 0; k < 3; ++k)
      mesh_.middles[pair_of(corners[(k + 1) % 3], corners[(k + 2) % 3])] = middles[k];
  }

  // The same point for the patches on both sides of the edge.
  PointId point_at(const std::array<PointId, 3>& corners, double place) {
    const auto edge = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(edge);
    PointId from = corners[edge % 3], to = corners[(edge + 1) % 3];
    if (share == 0) return from;
    const double from_lower = from < to ? share : 1 - share;
    if (from > to) std::swap(from, to);
    const auto [found, is_new] = on_edges_.try_emplace({pair_of(from, to), from_lower},
                                                       static_cast<PointId>(mesh_.points.size()));
    if (is_new)
      mesh_.points.push_back(
          ((1 - from_lower) * mesh_.points[from] + from_lower * mesh_.points[to]).normalized());
    return found->second;
  }

  void add_division(PatchId leaf, const PatchDivision& division) {
    const std::array<PointId, 3> corners = corners_of(leaf);
    const Eigen::Vector3d weights = division_middle(division);
    const auto middle = static_cast<PointId>(mesh_.points.size());
    mesh_.points.push_back((weights[0] * mesh_.points[corners[0]] +
                            weights[1] * mesh_.points[corners[1]] +
                            weights[2] * mesh_.points[corners[2]])
                               .normalized());
    for (const DivisionTriangle& triangle : division_triangles(division))
      mesh_.pieces.push_back(
          {{middle, point_at(corners, triangle.from), point_at(corners, triangle.to)},
           triangle.class_id});
  }

  const ViewSphere& sphere_;
  const SphereClasses& classes_;
  std::map<std::pair<std::uint64_t, double>, PointId> on_edges_;
  SphereMesh mesh_;
};

void append_side(const SphereMesh& mesh, PointId from, PointId to, std::vector<PointId>& rim) {
  const auto middle = mesh.middles.find(pair_of(from, to));
  if (middle == mesh.middles.end()) {
    rim.push_back(from);
    return;
  }
  append_side(mesh, from, middle->second, rim);
  append_side(mesh, middle->second, to, rim);
}

}  // namespace

std::vector<PointId> SphereMesh::rim(const SpherePiece& piece) const {
  std::vector<PointId> points_on;
  for (std::size_t k = 0; k < 3; ++k)
    append_side(*this, piece.corners[k], piece.corners[(k + 1) % 3], points_on);
  return points_on;
}

// Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983.
double SphereMesh::area_sr(const SpherePiece& piece) const {
  const Eigen::Vector3d &a = points[piece.corners[0]], &b = points[piece.corners[1]],
                        &c = points[piece.corners[2]];
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

std::vector<MeshSide> sides_of(const SphereMesh& mesh) {
  std::unordered_map<std::uint64_t, std::size_t> first;
  std::vector<MeshSide> sides;
  for (std::size_t piece = 0; piece < mesh.pieces.size(); ++piece) {
    const std::vector<PointId> rim = mesh.rim(mesh.pieces[piece]);
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const PointId from = rim[k], to = rim[(k + 1) % rim.size()];
      const auto [other, is_new] = first.try_emplace(pair_of(from, to), piece);
      if (!is_new) sides.push_back({from, to, other->second, piece});
    }
  }
  return sides;
}

SphereMesh sphere_mesh(const ViewSphere& sphere, const SphereClasses& classes) {
  return MeshOfSphere(sphere, classes).run();
}

}  // namespace aspect
