// Patterns on surfaces.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace aspect {

// Row by row, top to bottom, 3 bytes a pixel: parts of 255, linear like all colours here.
struct TextureMap {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;
};

// Cubes of side 1, white or as named, by turns in all three directions.
struct Checker {
  std::array<Eigen::Vector3d, 2> colors{Eigen::Vector3d{1, 1, 1}, Eigen::Vector3d{0, 0, 0}};
};

// A picture over the primitive's u and v, from 0 to 1 each, repeated beyond: u to the right, v
// upwards. What u and v are: compiler/render/texture_color.h.
struct ImageMap {
  std::shared_ptr<const TextureMap> picture;
};

struct Texture {
  std::variant<Checker, ImageMap> pattern;
  Eigen::Affine3d frame_from_object = Eigen::Affine3d::Identity();  // where the surface is written
  // The steps written inside the texture, undone: on the frame's x y z for a checker, on u v 0 for
  // a map.
  Eigen::Affine3d pattern_from_frame = Eigen::Affine3d::Identity();
};

}  // namespace aspect
