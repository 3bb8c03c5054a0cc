#include "compiler/render/camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace aspect {
namespace {

// Depends on `up` only, so that all views of a scene share it.
Eigen::Vector3d stand_in_for(const Eigen::Vector3d& up) {
  Eigen::Index axis = 0;
  up.cwiseAbs().minCoeff(&axis);
  return Eigen::Vector3d::Unit(axis);
}

}  // namespace

Intrinsics intrinsics_of(const Studio& studio) {
  Intrinsics result;
  result.width_px = studio.width_px;
  result.height_px = studio.height_px;
  if (studio.lens) {
    const Lens& lens = *studio.lens;
    return {studio.width_px, studio.height_px, lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px};
  }
  const double half_angle = studio.angle_deg * std::numbers::pi / 360;
  result.projection = studio.projection;
  result.fx_px = studio.projection == Projection::kOrthogonal
                     ? studio.width_px / studio.width
                     : studio.width_px / (2 * std::tan(half_angle));
  result.fy_px = result.fx_px * studio.aspect * studio.height_px / studio.width_px;
  result.cx_px = (studio.width_px - 1) / 2.0;
  result.cy_px = (studio.height_px - 1) / 2.0;
  return result;
}

Camera camera_at(const Studio& studio, const Eigen::Vector3d& direction_object, double distance) {
  // Below this sine the rounding of `up` would choose the camera's roll.
  constexpr double kParallel = 1e-9;

  const Eigen::Vector3d z = -direction_object;
  Eigen::Vector3d x = z.cross(studio.up);
  if (x.norm() <= kParallel * studio.up.norm()) x = z.cross(stand_in_for(studio.up));
  x.normalize();

  Camera camera;
  camera.intrinsics = intrinsics_of(studio);
  camera.camera_from_object.row(0) = x;
  camera.camera_from_object.row(1) = z.cross(x);
  camera.camera_from_object.row(2) = z;
  camera.position_object = studio.at + distance * direction_object;
  return camera;
}

Camera camera_at(const Studio& studio, const Eigen::Vector3d& direction_object) {
  return camera_at(studio, direction_object, studio.distance);
}

ViewRay view_ray(const Camera& camera, double x_px, double y_px) {
  const Eigen::Vector3d at_depth_0 = camera.intrinsics.point_camera(x_px, y_px, 0);
  const Eigen::Vector3d at_depth_1 = camera.intrinsics.point_camera(x_px, y_px, 1);
  const Eigen::Matrix3d object_from_camera = camera.camera_from_object.transpose();
  return {camera.position_object + object_from_camera * at_depth_0,
          object_from_camera * (at_depth_1 - at_depth_0)};
}

}  // namespace aspect
