// The colour of a pixel in scenes that need single rays: antialiasing, jitter and the lens.
//
// Whatever the samples, a picture's surface ids and depths are those of the rays through the
// pixels' centres; only colours are means of samples, each cut off at 1.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "compiler/render/camera.h"
#include "compiler/render/embree_scene.h"
#include "compiler/render/ray_shading.h"
#include "compiler/render/renderer.h"

namespace aspect {

// For one view.
class PixelSampling {
 public:
  PixelSampling(const RayShading& shading, const EmbreeScene& embree, const Camera& camera);

  // Colours a picture whose surface ids are there already.
  void color(const std::vector<std::uint8_t>& no_antialias_by_surface, Picture& picture);

 private:
  // Sixteenths of a pixel, from the picture's upper left corner: a pixel's centre is at 8, 8.
  struct Point {
    std::int64_t x = 0, y = 0;
  };
  // Of a square, row by row.
  using Corners = std::array<Eigen::Vector3d, 4>;

  Eigen::Vector3d sample(const Point& point, bool may_move) const;
  Eigen::Vector3d split(const Point& least, std::int64_t side, const Corners& corners) const;
  Eigen::Vector3d pixel(int x, int y, bool is_border, const Corners* corners) const;
  void sample_row_of_corners(int row, std::vector<Eigen::Vector3d>& corners) const;

  const RayShading& shading_;
  const EmbreeScene& embree_;
  const Camera& camera_;
  const Studio& studio_;
  double focal_depth_ = 0;
  int lens_samples_ = 1;
  std::int64_t least_side_ = 0;  // of a piece of a pixel
};

}  // namespace aspect
