#include "tests/runtime/recognition/painted_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

// x and y in pixels, and 1 / depth.
Vector3d projected(const Vector3d& p, const CameraModel& camera) {
  return {camera.cx_px + camera.fx_px * p[0] / p[2], camera.cy_px + camera.fy_px * p[1] / p[2],
          1 / p[2]};
}

double area(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

struct Canvas {
  OwnedFrame& frame;
  std::vector<double> nearness;
};

void paint_triangle(const std::array<Vector3d, 3>& p, const std::array<float, 3>& share,
                    Canvas& canvas) {
  constexpr float kBrightness = 300;
  const double all = area(p[0], p[1], p[2]);
  if (all == 0) return;
  const auto [left, right] = std::minmax({p[0][0], p[1][0], p[2][0]});
  const auto [top, bottom] = std::minmax({p[0][1], p[1][1], p[2][1]});
  for (int y = std::max(0, static_cast<int>(top));
       y <= std::min(canvas.frame.height_px - 1, static_cast<int>(bottom)); ++y)
    for (int x = std::max(0, static_cast<int>(left));
         x <= std::min(canvas.frame.width_px - 1, static_cast<int>(right)); ++x) {
      const Vector3d q{static_cast<double>(x), static_cast<double>(y), 0};
      const double a = area(q, p[1], p[2]) / all, b = area(p[0], q, p[2]) / all, c = 1 - a - b;
      if (std::min({a, b, c}) < 0) continue;
      const double nearness = a * p[0][2] + b * p[1][2] + c * p[2][2];
      const auto place = static_cast<std::size_t>(y * canvas.frame.width_px + x);
      if (nearness <= canvas.nearness[place]) continue;
      canvas.nearness[place] = nearness;
      for (std::size_t k = 0; k < 3; ++k)
        canvas.frame.rgb[3 * place + k] =
            static_cast<std::uint8_t>(std::lround(kBrightness * share[k]));
    }
}

}  // namespace

void paint(std::span<const PlacedModel> placed, const CameraModel& camera, OwnedFrame& onto) {
  Canvas canvas{onto, std::vector<double>(onto.rgb.size() / 3)};
  for (const PlacedModel& object : placed)
    for (const ModelTriangle& triangle : object.model->triangles) {
      std::array<Vector3d, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = projected(object.pose(object.model->vertices[triangle.corners[k]]), camera);
      const bool is_black = triangle.colour == kBackgroundClass;
      paint_triangle(corners,
                     is_black ? std::array<float, 3>{} : object.model->shares[triangle.colour - 1U],
                     canvas);
    }
}

CameraModel centred_camera(double field_of_view_deg, int width_px, int height_px) {
  const double focal_px = width_px / (2 * portable_tan(field_of_view_deg * std::numbers::pi / 360));
  return {focal_px, focal_px, (width_px - 1) / 2.0, (height_px - 1) / 2.0};
}

}  // namespace aspect
