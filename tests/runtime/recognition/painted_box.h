// A box of six colours, as simple as an object with a pose can be.
#pragma once

#include <array>
#include <cstdint>

#include "runtime/recognition/object_model.h"

namespace aspect {

// Corners of each face in turn: behind and before along z, then along y, then along x. Its paint
// has the face's number.
inline constexpr std::array<std::array<std::uint16_t, 4>, 6> kBoxFaces{
    {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};

// Each face is as far as that from the middle, which is the origin.
inline PaintedModel painted_box(double x, double y, double z) {
  PaintedModel box;
  for (int k = 0; k < 8; ++k)
    box.vertices.push_back({(k & 1) != 0 ? x : -x, (k & 2) != 0 ? y : -y, (k & 4) != 0 ? z : -z});
  box.paints = {{200, 20, 20},  {20, 200, 20},  {20, 20, 200},
                {200, 200, 20}, {20, 200, 200}, {200, 20, 200}};
  for (std::size_t f = 0; f < kBoxFaces.size(); ++f) {
    const auto& [a, b, c, d] = kBoxFaces[f];
    box.triangles.push_back({{a, b, c}, static_cast<std::uint8_t>(f)});
    box.triangles.push_back({{a, c, d}, static_cast<std::uint8_t>(f)});
  }
  return box;
}

}  // namespace aspect
