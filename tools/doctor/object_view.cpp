#include "tools/doctor/object_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/scene/scene_extent.h"
#include "tools/draw/paper.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kAngle_deg = 32;  // as a person holds a thing before the eyes
constexpr double kSlack = 0.006;   // of the object's radius

// Of the surface at a pixel, from those beside it as far as they show the same one.
std::optional<Vector3d> normal_at(const Picture& picture, const Intrinsics& in, int x, int y) {
  const auto place = [&](int px, int py) {
    return static_cast<std::size_t>(py) * static_cast<std::size_t>(picture.width_px) +
           static_cast<std::size_t>(px);
  };
  const std::uint16_t own = picture.surface[place(x, y)];
  const auto along = [&](int dx, int dy) -> std::optional<Vector3d> {
    int before = 1, after = 1;
    const auto is_same = [&](int px, int py) {
      return px >= 0 && py >= 0 && px < picture.width_px && py < picture.height_px &&
             picture.surface[place(px, py)] == own;
    };
    if (!is_same(x - dx, y - dy)) before = 0;
    if (!is_same(x + dx, y + dy)) after = 0;
    if (before + after == 0) return std::nullopt;
    const auto point = [&](int px, int py) {
      return in.point_camera(px, py, static_cast<double>(picture.depth[place(px, py)]));
    };
    return Vector3d(point(x + after * dx, y + after * dy) -
                    point(x - before * dx, y - before * dy));
  };
  const auto across = along(1, 0), down = along(0, 1);
  if (!across || !down) return std::nullopt;
  const Vector3d normal = across->cross(*down);
  const double length = normal.norm();
  if (!(length > 0)) return std::nullopt;
  return Vector3d(normal / length);
}

}  // namespace

Scene scene_for_views(const Scene& scene) {
  Scene shown = scene;
  const SceneExtent extent = scene_extent(scene);
  Studio studio;
  studio.at = (extent.least + extent.most) / 2;
  studio.up = scene.studio.up;
  studio.angle_deg = kAngle_deg;
  const double radius = std::max((extent.most - extent.least).norm() / 2, 1e-9);
  studio.distance = 1.06 * radius / std::sin(kAngle_deg / 2 * std::numbers::pi / 180);
  studio.ambient = {1, 1, 1};
  shown.studio = studio;
  shown.lights.clear();
  for (Surface& surface : shown.surfaces) {
    surface.ambient = surface.diffuse;
    surface.specular = surface.transparent = {0, 0, 0};
    surface.shine = surface.fuzz = 0;
  }
  return shown;
}

ObjectView::ObjectView(const Renderer& renderer, const Studio& studio,
                       const Vector3d& direction_unit, int side_px)
    : direction_(direction_unit) {
  Studio sized = studio;
  sized.width_px = sized.height_px = side_px;
  camera_ = camera_at(sized, direction_unit);
  renderer.render(camera_, picture_);
  slack_ = kSlack * studio.distance * std::sin(kAngle_deg / 2 * std::numbers::pi / 180);
}

std::optional<Vector3d> ObjectView::project(const Vector3d& point_object) const {
  const Vector3d p = camera_.camera_from_object * (point_object - camera_.position_object);
  const Intrinsics& in = camera_.intrinsics;
  if (!(p.z() > 1e-6 * slack_)) return std::nullopt;
  return Vector3d(in.cx_px + in.fx_px * p.x() / p.z(), in.cy_px + in.fy_px * p.y() / p.z(), p.z());
}

bool ObjectView::shows(const Vector3d& projected) const {
  const int x = static_cast<int>(std::lround(std::clamp(projected.x(), -9.0, 1e5))),
            y = static_cast<int>(std::lround(std::clamp(projected.y(), -9.0, 1e5)));
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const int px = x + i, py = y + j;
      if (px < 0 || py < 0 || px >= picture_.width_px || py >= picture_.height_px) continue;
      const auto place = static_cast<std::size_t>(py) * static_cast<std::size_t>(side_px()) +
                         static_cast<std::size_t>(px);
      if (static_cast<double>(picture_.depth[place]) >= projected.z() - slack_) return true;
    }
  return false;
}

double ObjectView::depth_on_plane(double x_px, double y_px, const Vector3d& point_object,
                                  const Vector3d& normal_object) const {
  const Vector3d point = camera_.camera_from_object * (point_object - camera_.position_object);
  const Vector3d normal = camera_.camera_from_object * normal_object;
  return normal.dot(point) / normal.dot(camera_.intrinsics.point_camera(x_px, y_px, 1));
}

bool ObjectView::touch(std::size_t pixel, std::size_t next) const {
  constexpr double kTouching_px = 3;
  const auto a = static_cast<double>(picture_.depth[pixel]),
             b = static_cast<double>(picture_.depth[next]);
  return std::abs(a - b) <= kTouching_px * std::min(a, b) / camera_.intrinsics.fx_px;
}

cv::Mat ObjectView::drawn() const {
  constexpr double kDarkest = 0.66;
  cv::Mat drawn(picture_.height_px, picture_.width_px, CV_8UC3, kPaper);
  for (int y = 0; y < picture_.height_px; ++y)
    for (int x = 0; x < picture_.width_px; ++x) {
      const auto place = static_cast<std::size_t>(y) * static_cast<std::size_t>(side_px()) +
                         static_cast<std::size_t>(x);
      if (picture_.surface[place] == 0) continue;
      const Vector3d ray = camera_.intrinsics.point_camera(x, y, 1).normalized();
      const auto normal = normal_at(picture_, camera_.intrinsics, x, y);
      const double light =
          normal ? kDarkest + (1 - kDarkest) * std::abs(normal->dot(ray)) : (1 + kDarkest) / 2;
      const std::uint8_t* rgb = picture_.rgb.data() + 3 * place;
      for (int c = 0; c < 3; ++c)
        drawn.at<cv::Vec3b>(y, x)[2 - c] = cv::saturate_cast<std::uint8_t>(light * rgb[c]);
    }
  return drawn;
}

}  // namespace aspect
