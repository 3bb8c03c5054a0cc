#include "tools/aspectc/distance_check.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "compiler/aspects/observer.h"
#include "compiler/scene/scene_bounds.h"
#include "compiler/viewsphere/viewsphere.h"

namespace aspect {
namespace {

double radius_around(const Scene& scene, const Eigen::Vector3d& centre) {
  double radius = 0;
  for (const Primitive& primitive : scene.primitives)
    radius = std::max(radius, farthest_distance(primitive, centre));
  return radius;
}

// What a primitive shows in a picture.
struct SurfacePixels {
  std::array<double, 3> sums{};
  std::uint32_t count = 0;
};

std::map<int, SurfacePixels> surfaces_of(const Picture& picture) {
  std::map<int, SurfacePixels> surfaces;
  for (std::size_t i = 0; i < picture.surface.size(); ++i) {
    if (picture.surface[i] == 0) continue;
    SurfacePixels& pixels = surfaces[picture.surface[i]];
    ++pixels.count;
    for (std::size_t k = 0; k < 3; ++k) pixels.sums[k] += picture.rgb[3 * i + k];
  }
  return surfaces;
}

// Smoothing gives the pixels of what is too small to what is around it.
bool has_colour_of(const ObservedContour& contour, const SurfacePixels& pixels) {
  constexpr double kSame = 0.1;  // of a colour share: a few chroma steps
  const double total = std::max(pixels.sums[0] + pixels.sums[1] + pixels.sums[2], 1.0);
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(static_cast<double>(contour.feature.share[k]) - pixels.sums[k] / total) > kSame)
      return false;
  return true;
}

// For each primitive that is mostly part of one contour of its colour: that contour's pixels.
void note_contours(const ObservedView& view, const Picture& picture,
                   std::map<int, double>& largest) {
  const std::map<int, SurfacePixels> surfaces = surfaces_of(picture);
  for (const auto& [surface, pixels] : surfaces) largest.try_emplace(surface, 0);
  for (const ObservedContour& contour : view.contours) {
    for (const auto& [surface, seen] : contour.surfaces) {
      const auto pixels = surfaces.find(surface);
      if (pixels == surfaces.end() || 2 * seen < pixels->second.count) continue;
      if (!has_colour_of(contour, pixels->second)) continue;
      largest[surface] = std::max(largest[surface], static_cast<double>(contour.area_px));
    }
  }
}

}  // namespace

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
  constexpr int kLevel = 1;  // 42 views
  const Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return {};
  Studio studio = scene.studio;
  studio.distance = distance;
  VisionParameters all = vision;
  all.area_min_px = 1;
  all.thickness_min_px = 0;
  Observer observer(renderer.value(), studio, all);
  std::map<int, double> largest;
  ViewSphere sphere;
  for (int level = 0; level < kLevel; ++level)
    for (const PatchId leaf : sphere.leaves()) sphere.split(leaf);
  for (std::size_t vertex = 0; vertex < sphere.vertex_count(); ++vertex) {
    const ObservedView view = observer.observe(sphere.position(static_cast<VertexId>(vertex)));
    note_contours(view, observer.picture(), largest);
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
