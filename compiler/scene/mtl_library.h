// The materials of OBJ files.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

struct MtlMaterial {
  std::filesystem::path library;          // that defines it
  std::optional<Eigen::Vector3d> colour;  // Kd, as displayed
  std::size_t colour_line = 0;
  std::string unread;   // what Kd is where it is no colour that is read
  std::string picture;  // map_Kd
  std::size_t picture_line = 0;
  Eigen::Vector2d picture_scale{1, 1}, picture_offset{0, 0};  // of texture coordinates
};

using MtlMaterials = std::map<std::string, MtlMaterial, std::less<>>;

// Adds what the text of `file` defines; of a material that is defined twice the last value counts.
// Read are Kd (r g b, r alone, xyz) and map_Kd with -s and -o. Throws MeshError. Format:
// Wavefront's "Material Library File (MTL)", 1995.
void read_mtl(std::string_view text, const std::filesystem::path& file, MtlMaterials& materials,
              std::vector<std::string>& warnings);

}  // namespace aspect
