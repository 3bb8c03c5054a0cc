// A view of an object for people: in its own colours without lamps, gently shaded by how its
// surfaces lie, all of it in the picture from every side.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"

namespace aspect {

// The scene with a studio for such views: seen from outside, its middle in the middle.
Scene scene_for_views(const Scene& scene);

class ObjectView {
 public:
  // The renderer and the studio are those of scene_for_views(); a square.
  ObjectView(const Renderer& renderer, const Studio& studio, const Eigen::Vector3d& direction_unit,
             int side_px);

  const Eigen::Vector3d& direction() const { return direction_; }
  int side_px() const { return picture_.width_px; }
  const Picture& picture() const { return picture_; }

  // x and y in the picture and the depth; nothing of what is behind the camera.
  std::optional<Eigen::Vector3d> project(const Eigen::Vector3d& point_object) const;
  // Whether no surface lies before the point that project() gave.
  bool shows(const Eigen::Vector3d& projected) const;
  // The depth of a plane where the picture shows it at that pixel.
  double depth_on_plane(double x_px, double y_px, const Eigen::Vector3d& point_object,
                        const Eigen::Vector3d& normal_object) const;
  // Whether what two neighbouring pixels show is at nearly one depth: it touches.
  bool touch(std::size_t pixel, std::size_t next) const;

  // On light paper, BGR.
  cv::Mat drawn() const;

 private:
  Eigen::Vector3d direction_;
  Camera camera_;
  Picture picture_;
  double slack_ = 0;  // of depths: what lies on a surface is not before it
};

}  // namespace aspect
