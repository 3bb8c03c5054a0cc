#include "compiler/scene/coloured_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "compiler/scene/ear_clipping.h"

namespace aspect {
namespace {

// Its corners' distance from a common plane, as a share of its size, is more than rounding.
bool is_warped(const std::vector<Eigen::Vector3d>& quad) {
  const Eigen::Vector3d u = quad[2] - quad[0], v = quad[3] - quad[1];
  const double size = std::max(u.norm(), v.norm());
  return std::abs(u.cross(v).normalized().dot(quad[1] - quad[0])) > 1e-6 * size;
}

void add_triangle(ColouredMesh& mesh, const Triangle& triangle, const Eigen::Vector3d& colour,
                  std::uint32_t part) {
  if (mesh.triangles.size() == ColouredMesh::kMaxTriangles)
    throw MeshError(
        fmt::format("more than {} triangles; simplify the model", ColouredMesh::kMaxTriangles));
  mesh.triangles.push_back(triangle);
  mesh.colours.push_back(colour);
  mesh.part_of.push_back(part);
}

}  // namespace

std::uint32_t add_vertex(ColouredMesh& mesh, const Eigen::Vector3d& vertex) {
  if (mesh.vertices.size() == ColouredMesh::kMaxVertices)
    throw MeshError(
        fmt::format("more than {} vertices; simplify the model", ColouredMesh::kMaxVertices));
  mesh.vertices.push_back(vertex);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_face(ColouredMesh& mesh, std::span<const std::uint32_t> corners,
              const Eigen::Vector3d& colour, std::uint32_t part) {
  if (corners.size() > ColouredMesh::kMaxFaceCorners)
    throw MeshError(fmt::format("a face of {} corners, at most {} are read; write triangles",
                                corners.size(), ColouredMesh::kMaxFaceCorners));
  std::vector<Eigen::Vector3d> polygon;
  for (const std::uint32_t corner : corners) {
    if (corner >= mesh.vertices.size())
      throw MeshError(fmt::format("a face has vertex {}, but there are {}; export it again", corner,
                                  mesh.vertices.size()));
    polygon.push_back(mesh.vertices[corner]);
    if (!polygon.back().allFinite())
      throw MeshError(fmt::format("vertex {} is not finite; export it again", corner));
  }
  if (corners.size() == 3)
    return add_triangle(mesh, {corners[0], corners[1], corners[2]}, colour, part);
  // A warped one is two triangles whichever way it is looked at.
  if (corners.size() == 4 && is_warped(polygon)) {
    add_triangle(mesh, {corners[0], corners[1], corners[2]}, colour, part);
    return add_triangle(mesh, {corners[0], corners[2], corners[3]}, colour, part);
  }
  for (const auto& [a, b, c] : triangulate(polygon))
    add_triangle(mesh, {corners[a], corners[b], corners[c]}, colour, part);
}

void warn_of_uncoloured(ColouredMesh& mesh, std::size_t uncoloured, std::size_t faces) {
  if (uncoloured == faces)
    mesh.warnings.push_back("holds no colours; all of it is grey");
  else if (uncoloured > 0)
    mesh.warnings.push_back(
        fmt::format("{} of {} faces have no colour; they are grey", uncoloured, faces));
}

}  // namespace aspect
