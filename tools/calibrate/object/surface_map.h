// Which of a scene's surfaces every pixel of a frame shows, as its object's pose has it.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"
#include "tools/calibrate/object/posed_frames.h"

namespace aspect {

// Surfaces that have one colour in the scene: they are painted alike, and cannot be told apart.
struct Paint {
  std::vector<int> surfaces;       // places in Scene::surfaces
  Eigen::Vector3d shown{0, 0, 0};  // as the scene shows it: ambient or diffuse colour, 0 to 1
  bool textured = false;
  bool is_background = false;  // too dark to be told from it
};

// Of the surfaces that primitives have, in the order of the scene's. Dark: r + g + b below
// intensity_min.
std::vector<Paint> paints_of(const Scene& scene, int intensity_min);
// The place of a surface's paint, by place of the surface; -1 where no primitive has it.
std::vector<int> paint_by_surface(const Scene& scene, const std::vector<Paint>& paints);

// Its shares of r, g, b: what is left when brightness is taken away.
Eigen::Vector3d shares_of(const Eigen::Vector3d& colour);

class SurfaceMapper {
 public:
  static Result<SurfaceMapper> create(const Scene& scene, const std::vector<Paint>& paints);

  // CV_16S, the frame's size: the place of the paint that is seen, -1: not the object, or a paint
  // that is background. The lens is bent as the frame's is.
  cv::Mat paints(const PosedFrame& frame);
  // Likewise, but of primitives: those of one paint that meet at an edge are told apart. 0: none.
  cv::Mat primitives(const PosedFrame& frame);

 private:
  SurfaceMapper(Renderer renderer, std::vector<int> paint_of_primitive)
      : renderer_(std::move(renderer)), paint_of_primitive_(std::move(paint_of_primitive)) {}

  Renderer renderer_;
  std::vector<int> paint_of_primitive_;
  Picture picture_;
};

// Pixels from the nearest one that shows something else, the frame's rim not counted: CV_32F.
cv::Mat distance_to_border(const cv::Mat& paints);

}  // namespace aspect
