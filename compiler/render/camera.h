// The camera of a view: a pinhole on the viewing sphere, or a screen of parallel rays there.
#pragma once

#include <Eigen/Core>

#include "compiler/scene/scene.h"

namespace aspect {

// Pixel centres are at whole numbers; x right, y down, z forward (OpenCV's convention).
struct Intrinsics {
  int width_px = 512;
  int height_px = 512;
  // Pixels at depth 1 a unit of length; in an orthogonal projection at every depth.
  double fx_px = 0, fy_px = 0, cx_px = 0, cy_px = 0;
  Projection projection = Projection::kPerspective;

  // The point that the picture shows there, in camera coordinates.
  Eigen::Vector3d point_camera(double x_px, double y_px, double depth) const {
    const double spread = projection == Projection::kPerspective ? depth : 1;
    return {(x_px - cx_px) / fx_px * spread, (y_px - cy_px) / fy_px * spread, depth};
  }
};

struct Camera {
  Intrinsics intrinsics;
  Eigen::Matrix3d camera_from_object;  // rotation
  Eigen::Vector3d position_object;     // camera centre in object coordinates
};

// What a point of the picture shows lies at origin + depth * direction.
struct ViewRay {
  Eigen::Vector3d origin_object;
  Eigen::Vector3d direction_object;
};

// The studio's lens where it has one, otherwise fx = width / 2 / tan(angle / 2), or width /
// studio.width in an orthogonal projection; square pixels unless the studio's aspect differs from
// the resolution's.
Intrinsics intrinsics_of(const Studio& studio);

// The camera at studio.at + distance * direction_object (a unit vector), looking at studio.at with
// studio.up upwards: z = -direction, x = normalised cross(z, up), y = cross(z, x). Where up is
// parallel to the direction, another axis stands in for it, always the same one.
Camera camera_at(const Studio& studio, const Eigen::Vector3d& direction_object, double distance);
// At the studio's own distance.
Camera camera_at(const Studio& studio, const Eigen::Vector3d& direction_object);

ViewRay view_ray(const Camera& camera, double x_px, double y_px);

}  // namespace aspect
