// Corners are hashed by cells a few tolerances wide; only those near a cell's side look beyond it.
#include "tools/doctor/face_set.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 1e-6;  // of the diameter: above the rounding of single precision
constexpr double kCell = 16;         // tolerances
constexpr std::size_t kMostCracks = 1000;

class Welder {
 public:
  Welder(FaceSet& set, const Vector3d& least) : set_(set), least_(least) {}

  std::uint32_t add(const Vector3d& point) {
    const Vector3d cell = cell_of(point);
    if (const auto found = find(point)) {
      if (set_.vertices[*found] != point) {
        ++set_.cracked;
        if (set_.cracks.size() < kMostCracks) set_.cracks.push_back(*found);
      }
      return *found;
    }
    const auto index = static_cast<std::uint32_t>(set_.vertices.size());
    set_.vertices.push_back(point);
    cells_[key_of(cell)].push_back(index);
    return index;
  }

 private:
  Vector3d cell_of(const Vector3d& point) const {
    return ((point - least_) / (kCell * set_.tolerance)).array().floor();
  }
  static std::uint64_t key_of(const Vector3d& cell) {
    const auto index = [](double value) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) & 0x1fffffU;
    };
    return index(cell.x()) << 42U | index(cell.y()) << 21U | index(cell.z());
  }

  std::optional<std::uint32_t> find(const Vector3d& point) const {
    const Vector3d least = cell_of(point - Vector3d::Constant(set_.tolerance));
    const Vector3d most = cell_of(point + Vector3d::Constant(set_.tolerance));
    std::optional<std::uint32_t> best;
    for (double x = least.x(); x <= most.x(); ++x)
      for (double y = least.y(); y <= most.y(); ++y)
        for (double z = least.z(); z <= most.z(); ++z) look({x, y, z}, point, best);
    return best;
  }
  void look(const Vector3d& cell, const Vector3d& point, std::optional<std::uint32_t>& best) const {
    const auto found = cells_.find(key_of(cell));
    if (found == cells_.end()) return;
    for (const std::uint32_t index : found->second)
      if ((set_.vertices[index] - point).cwiseAbs().maxCoeff() <= set_.tolerance &&
          (!best || index < *best))
        best = index;
  }

  FaceSet& set_;
  Vector3d least_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

FaceSet empty_set(const Eigen::AlignedBox3d& box) {
  FaceSet set;
  set.diameter = box.isEmpty() ? 0 : box.diagonal().norm();
  set.tolerance = std::max(kTolerance * set.diameter, 1e-300);
  return set;
}

void add_face(FaceSet& set, Welder& welder, std::span<const Vector3d> points,
              const FaceSet::Face& face) {
  set.faces.push_back(face);
  set.faces.back().first = set.corners.size();
  set.faces.back().count = points.size();
  for (const Vector3d& point : points) set.corners.push_back(welder.add(point));
}

std::span<const Vector3d> points_of(const Primitive& primitive) {
  if (const auto* polygon = std::get_if<Polygon>(&primitive.shape)) return polygon->vertices;
  if (const auto* smooth = std::get_if<SmoothTriangle>(&primitive.shape)) return smooth->vertices;
  return {};
}

}  // namespace

FaceSet face_set_of(const ColouredMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) box.extend(mesh.vertices[corner]);
  FaceSet set = empty_set(box);
  set.wound = true;
  Welder welder(set, box.min());
  constexpr std::uint32_t kUnused = ~0U;
  std::vector<std::uint32_t> welded(mesh.vertices.size(), kUnused);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    set.faces.push_back({set.corners.size(), 3, t, mesh.colours[t]});
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (welded[corner] == kUnused) welded[corner] = welder.add(mesh.vertices[corner]);
      set.corners.push_back(welded[corner]);
    }
  }
  return set;
}

FaceSet face_set_of(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Primitive& primitive : scene.primitives)
    for (const Vector3d& point : points_of(primitive)) box.extend(point);
  FaceSet set = empty_set(box);
  if (box.isEmpty()) return set;
  Welder welder(set, box.min());
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const Primitive& primitive = scene.primitives[k];
    if (points_of(primitive).empty()) continue;
    const Surface& surface = scene.surfaces[static_cast<std::size_t>(primitive.surface)];
    add_face(set, welder, points_of(primitive), {0, 0, k, surface.diffuse});
  }
  set.cracked = 0;  // each polygon has corners of its own; how they are written does not matter
  set.cracks.clear();
  return set;
}

}  // namespace aspect
