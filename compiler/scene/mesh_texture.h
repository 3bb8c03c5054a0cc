// Pictures on faces: cut into triangles of one colour each.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

struct MeshTexture {
  enum class Wrap { repeat, clamp, mirror };  // beyond 0..1

  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;  // row by row, top to bottom
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;

  // (0, 0) is the lower left corner of the picture.
  Eigen::Vector3d at(const Eigen::Vector2d& uv) const;
};

// Throws MeshError where the bytes are no picture that is read.
MeshTexture decode_texture(std::span<const std::uint8_t> file);

struct TexturedTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  std::array<Eigen::Vector2d, 3> uv;
  Eigen::Vector3d factor{1, 1, 1};  // of the texture's colours
  bool linear_factor = false;       // of their light, not of their values
  std::uint32_t part = 0;
};

// Idea: a triangle whose texture is of one colour, to 24/255, becomes one with the mean colour; any
// other is cut into four at the middles of its edges, down to edges of `least_edge`, where the
// commonest colour wins (a mean would paint a line along every border). Colours within 12/255 of
// an earlier one of the same call become that one. Weak side: borders are jagged by `least_edge`,
// and detail finer than 1/32 of a uniform-looking triangle is missed.
void add_textured(ColouredMesh& mesh, std::span<const TexturedTriangle> triangles,
                  const MeshTexture& texture, double least_edge);

}  // namespace aspect
