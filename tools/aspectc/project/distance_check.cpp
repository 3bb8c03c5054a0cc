#include "tools/aspectc/project/distance_check.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "compiler/aspects/observer.h"
#include "compiler/scene/scene_bounds.h"
#include "tools/aspectc/project/visible_contours.h"

namespace aspect {

double radius_around(const Scene& scene, const Eigen::Vector3d& centre) {
  double radius = 0;
  for (const Primitive& primitive : scene.primitives)
    radius = std::max(radius, farthest_distance(primitive, centre));
  return radius;
}

double fitting_radius_at(const Studio& studio, double distance) {
  const Intrinsics in = intrinsics_of(studio);
  const double tangent =
      std::min({(in.cx_px + 0.5) / in.fx_px, (in.width_px - 0.5 - in.cx_px) / in.fx_px,
                (in.cy_px + 0.5) / in.fy_px, (in.height_px - 0.5 - in.cy_px) / in.fy_px});
  // The cone of rays that touches a sphere of radius r at distance d opens by asin(r / d).
  return distance * std::sin(std::atan(std::max(tangent, 0.0)));
}

SmallestContour smallest_contour_at(const Scene& scene, const VisionParameters& vision,
                                    double distance) {
  const Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return {};
  Studio studio = scene.studio;
  studio.distance = distance;
  VisionParameters all = vision;
  all.area_min_px = 1;
  all.thickness_min_px = 0;
  Observer observer(renderer.value(), studio, all);
  std::map<int, double> largest;
  for (const Eigen::Vector3d& direction : examined_directions()) {
    const ObservedView view = observer.observe(direction);
    note_contours(view, observer.picture(), vision.sensor, largest);
  }
  const auto least =
      std::min_element(largest.begin(), largest.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (least == largest.end()) return {};
  return {static_cast<int>(least->second), least->first};
}

std::vector<std::string> distance_warnings(const Scene& scene, const VisionParameters& vision,
                                           double near, double far) {
  std::vector<std::string> warnings;
  const double radius = radius_around(scene, scene.studio.at);
  const double fitting = fitting_radius_at(scene.studio, near);
  if (radius > fitting)
    warnings.push_back(fmt::format(
        "{}: the object leaves the picture at distance {:g}: its radius is {:.4g}, {:.4g} fits; "
        "start the range at {:.4g}, or use a wider lens",
        scene.name, near, radius, fitting, near * radius / std::max(fitting, 1e-9)));
  const SmallestContour smallest = smallest_contour_at(scene, vision, far);
  if (smallest.area_px < vision.area_min_px)
    warnings.push_back(fmt::format(
        "{}: at distance {:g} the smallest contour (of surface {}) has {} pixels at most, fewer "
        "than area_min_px {}: it will not be seen; end the range nearer, take larger pictures, or "
        "lower area_min_px",
        scene.name, far, smallest.surface, smallest.area_px, vision.area_min_px));
  return warnings;
}

}  // namespace aspect
