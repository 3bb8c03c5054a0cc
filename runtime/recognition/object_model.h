// The object as triangles with colours, so that it can be drawn at any pose and compared with a
// picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/recognition/rigid_pose.h"

namespace aspect {

inline constexpr std::size_t kMaxModelVertices = 8192, kMaxModelTriangles = 8192,
                             kMaxModelColours = 64;

// 0: what cannot be told from the background; others are alike only where they are the same.
using ColourClass = std::uint8_t;
inline constexpr ColourClass kBackgroundClass = 0;

struct ModelTriangle {
  std::array<std::uint16_t, 3> corners{};  // into vertices
  ColourClass colour = kBackgroundClass;
  std::uint8_t paint = 0;  // into paints
};

// Between one triangle or two.
struct ModelEdge {
  std::array<std::uint16_t, 2> ends{};      // into vertices
  std::array<std::uint16_t, 2> opposite{};  // the triangles' third corners; the same: there is one
  std::array<ColourClass, 2> colours{};     // the triangles'
};

struct ObjectModel {
  std::vector<Vector3d> vertices;  // object coordinates
  std::vector<ModelTriangle> triangles;
  std::vector<ModelEdge> edges;              // without those that no picture shows
  std::vector<std::array<float, 3>> shares;  // of the colour classes, from 1 on: r, g, b of 1
  std::vector<std::array<std::uint8_t, 3>> paints;  // r g b, as the scene has them: for people
  Vector3d centre{}, up{0, 0, 1};                   // of the views, see camera_from_object
  double radius = 0;                                // of a ball about the centre that holds all
  double error = 0;                                 // largest distance to the scene's surface

  bool empty() const { return triangles.empty(); }
};

// A model as the index holds it: colours one by one.
struct PaintedModel {
  std::vector<Vector3d> vertices;
  struct Triangle {
    std::array<std::uint16_t, 3> corners{};
    std::uint8_t paint = 0;
  };
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint8_t, 3>> paints;  // r g b
};

// Joins paints that segmentation cannot part (shares that differ by no more than chroma_step, one
// after the other), makes dark ones background, and finds the edges. O(triangles log triangles).
ObjectModel prepared_model(const PaintedModel& painted, int chroma_step, int intensity_min);

}  // namespace aspect
