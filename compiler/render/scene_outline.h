// What is known of a scene before any ray is traced: for every primitive a wire frame around it,
// and the convex flat pieces of surface whose pictures are known exactly. Object coordinates.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/scene/ear_clipping.h"
#include "compiler/scene/scene.h"

namespace aspect {

struct SceneOutline {
  struct Edge {
    std::uint32_t from = 0, to = 0;  // points
  };

  // A primitive's wire frame. In every picture taken from outside, the border of the frame's area
  // is made of pictures of its edges, and the primitive lies within. The same index as the
  // primitive.
  struct Frame {
    std::uint32_t first_point = 0, end_point = 0;
    std::uint32_t first_edge = 0, end_edge = 0;
    bool flat = false;         // the primitive lies in one plane
    Eigen::Vector3d on_plane;  // where flat
    Eigen::Vector3d normal;    // where flat
  };

  // A convex flat polygon, all of it surface of the primitive.
  struct Plate {
    std::uint32_t primitive = 0;
    std::uint32_t first_corner = 0, end_corner = 0;
  };

  std::vector<Eigen::Vector3d> points;
  std::vector<Edge> edges;
  std::vector<Frame> frames;
  std::vector<Plate> plates;
  std::vector<std::uint32_t> corners;  // points
};

// `triangles` holds those of every polygon by primitive, and an empty list for all else.
SceneOutline outline_of(const Scene& scene, std::span<const std::vector<Triangle>> triangles);

}  // namespace aspect
