// What the lines of an OBJ file say.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

struct ObjCorner {
  std::uint32_t vertex = 0;
  std::optional<std::uint32_t> uv;
};

struct ObjFile {
  struct Face {
    std::size_t first_corner = 0, corner_count = 0;
    std::uint32_t part = 0;
    std::size_t line = 0;
  };
  // Faces of one object or group and one material that follow each other.
  struct Part {
    std::string name, material;
    std::size_t material_line = 0;
  };
  struct Library {
    std::string names;  // one, or several with spaces between
    std::size_t line = 0;
  };

  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::optional<Eigen::Vector3d>> colours;  // by vertex
  bool coloured = false;                                // some vertex is
  std::vector<Eigen::Vector2d> uv;
  std::vector<ObjCorner> corners;
  std::vector<Face> faces;
  std::vector<Part> parts;
  std::vector<Library> libraries;
  std::vector<std::string> warnings;
};

// All indices are within their lists. Throws MeshError with the line.
ObjFile read_obj_file(std::string_view text);

}  // namespace aspect
