// What the readers of mesh files hand over: triangles with a colour each, as the file says.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "compiler/scene/missing_colour.h"

namespace aspect {

// Thrown inside compiler/scene only; read_mesh() turns it into a Result with the file's name.
class MeshError : public std::runtime_error {
 public:
  explicit MeshError(const std::string& message, std::size_t line = 0, std::string file = {})
      : std::runtime_error(message), line_(line), file_(std::move(file)) {}
  std::size_t line() const { return line_; }         // 0: none
  const std::string& file() const { return file_; }  // empty: the mesh's own

 private:
  std::size_t line_;
  std::string file_;
};

// A named piece of a file: a mesh, solid, object or layer, and its material.
struct MeshPart {
  std::string name, material;
};

struct ColouredMesh {
  // Far above what a class index can tell apart, low enough to be safe.
  static constexpr std::size_t kMaxTriangles = 5'000'000;
  static constexpr std::size_t kMaxVertices = 3 * kMaxTriangles;
  static constexpr std::size_t kMaxFaceCorners = 10'000;

  std::vector<Eigen::Vector3d> vertices;                // the file's coordinates
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of vertices
  std::vector<Eigen::Vector3d> colours;                 // by triangle, 0..1
  std::vector<std::uint32_t> part_of;                   // by triangle: index into parts
  std::vector<MeshPart> parts;
  std::vector<std::string> warnings;   // without the file's name
  std::vector<MissingColour> missing;  // a colour that the reader was given stands for them
  std::vector<std::string> files;      // beside the mesh's own, that were read or looked for
};

// Of faces that have none.
inline const Eigen::Vector3d kUncoloured{0.7, 0.7, 0.7};

// Throws MeshError past kMaxVertices.
std::uint32_t add_vertex(ColouredMesh& mesh, const Eigen::Vector3d& vertex);

// The triangles of a face with any number of corners, by the places of their corners among its own;
// none of fewer than three.
std::vector<std::array<std::uint32_t, 3>> cut_face(std::span<const Eigen::Vector3d> corners);

// A face, cut into triangles. Throws MeshError where a corner is not there or a limit is passed.
void add_face(ColouredMesh& mesh, std::span<const std::uint32_t> corners,
              const Eigen::Vector3d& colour, std::uint32_t part);

// Warns where some faces of the file, or all, have no colour.
void warn_of_uncoloured(ColouredMesh& mesh, std::size_t uncoloured, std::size_t faces);

}  // namespace aspect
