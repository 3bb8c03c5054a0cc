#include "runtime/recognition/camera_model.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

double radial(const CameraModel& camera, double r2) {
  return 1 + r2 * (camera.k1 + r2 * (camera.k2 + r2 * camera.k3));
}

Point2d bend(const CameraModel& camera, Point2d p) {
  const double r2 = p.x * p.x + p.y * p.y, factor = radial(camera, r2);
  return {p.x * factor + 2 * camera.p1 * p.x * p.y + camera.p2 * (r2 + 2 * p.x * p.x),
          p.y * factor + camera.p1 * (r2 + 2 * p.y * p.y) + 2 * camera.p2 * p.x * p.y};
}

}  // namespace

Point2d CameraModel::bent(Point2d p) const {
  if (is_straight()) return p;
  const Point2d q = bend(*this, {(p.x - cx_px) / fx_px, (p.y - cy_px) / fy_px});
  return {cx_px + fx_px * q.x, cy_px + fy_px * q.y};
}

// Newton's method; a sound camera's slopes are far from zero wherever a picture has pixels.
Point2d CameraModel::straight(Point2d p) const {
  if (is_straight()) return p;
  constexpr int kRounds = 8;
  const Point2d target{(p.x - cx_px) / fx_px, (p.y - cy_px) / fy_px};
  Point2d q = target;
  for (int round = 0; round < kRounds; ++round) {
    const Point2d now = bend(*this, q);
    const double r2 = q.x * q.x + q.y * q.y, factor = radial(*this, r2);
    const double slope = 2 * (k1 + r2 * (2 * k2 + 3 * r2 * k3));  // of factor, by r2, twice
    const double xx = factor + slope * q.x * q.x + 2 * p1 * q.y + 6 * p2 * q.x,
                 xy = slope * q.x * q.y + 2 * p1 * q.x + 2 * p2 * q.y,
                 yy = factor + slope * q.y * q.y + 6 * p1 * q.y + 2 * p2 * q.x;
    const double determinant = xx * yy - xy * xy;
    if (!(std::abs(determinant) > 1e-6)) break;
    const double x = target.x - now.x, y = target.y - now.y;
    q = {q.x + (yy * x - xy * y) / determinant, q.y + (xx * y - xy * x) / determinant};
  }
  return {cx_px + fx_px * q.x, cy_px + fy_px * q.y};
}

bool is_sound(const CameraModel& camera, int width_px, int height_px) {
  for (const double x : {camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px, camera.k1,
                         camera.k2, camera.p1, camera.p2, camera.k3})
    if (!std::isfinite(x)) return false;
  if (!(camera.fx_px > 0 && camera.fy_px > 0)) return false;
  if (camera.is_straight()) return true;
  const double x =
      std::max(std::abs(camera.cx_px), std::abs(width_px - 1 - camera.cx_px)) / camera.fx_px;
  const double y =
      std::max(std::abs(camera.cy_px), std::abs(height_px - 1 - camera.cy_px)) / camera.fy_px;
  constexpr int kSteps = 64;
  constexpr double kLeastSlope = 0.2, kMostTangential = 0.1;
  if (std::abs(camera.p1) > kMostTangential || std::abs(camera.p2) > kMostTangential) return false;
  const double corner = std::sqrt(x * x + y * y);
  for (int step = 0; step <= kSteps; ++step) {
    const double r2 = corner * corner * step / kSteps * step / kSteps;
    if (1 + r2 * (3 * camera.k1 + r2 * (5 * camera.k2 + r2 * 7 * camera.k3)) < kLeastSlope)
      return false;
  }
  return true;
}

}  // namespace aspect
