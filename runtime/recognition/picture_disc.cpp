#include "runtime/recognition/picture_disc.h"

#include <algorithm>
#include <cmath>

namespace aspect {

PictureDisc disc_of(const ObjectModel& model, const RigidPose& pose, const CameraModel& camera) {
  const Vector3d centre = pose(model.centre);
  const double near = 1 / std::max(centre[2], 1e-9);
  return {camera.cx_px + camera.fx_px * centre[0] * near,
          camera.cy_px + camera.fy_px * centre[1] * near, model.radius * camera.fx_px * near};
}

double distance_px(const PictureDisc& a, const PictureDisc& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

bool share_place(const PictureDisc& a, const PictureDisc& b, double share) {
  return distance_px(a, b) < share * std::max(a.radius_px, b.radius_px);
}

}  // namespace aspect
