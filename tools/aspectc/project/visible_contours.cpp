#include "tools/aspectc/project/visible_contours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/viewsphere/viewsphere.h"

namespace aspect {
namespace {

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

}  // namespace

void note_contours(const ObservedView& view, const Picture& picture, SensorKind sensor,
                   std::map<int, double>& largest) {
  const std::map<int, SurfacePixels> surfaces = surfaces_of(picture);
  for (const auto& [surface, pixels] : surfaces) largest.try_emplace(surface, 0);
  for (const ObservedContour& contour : view.contours) {
    for (const auto& [surface, seen] : contour.surfaces) {
      const auto pixels = surfaces.find(surface);
      if (pixels == surfaces.end() || 2 * seen < pixels->second.count) continue;
      if (sensor == SensorKind::colour && !has_colour_of(contour, pixels->second)) continue;
      largest[surface] = std::max(largest[surface], static_cast<double>(contour.area_px));
    }
  }
}

std::vector<Eigen::Vector3d> examined_directions() {
  ViewSphere sphere;
  for (const PatchId leaf : sphere.leaves()) sphere.split(leaf);
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t vertex = 0; vertex < sphere.vertex_count(); ++vertex)
    directions.push_back(sphere.position(static_cast<VertexId>(vertex)));
  return directions;
}

}  // namespace aspect
