#include "tools/doctor/sight.h"

#include <algorithm>
#include <cmath>

#include "compiler/aspects/colour_separation.h"
#include "compiler/aspects/observer.h"
#include "tools/aspectc/project/visible_contours.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kTouching_px = 3;  // of depth between neighbouring pixels

Vector3d colour_at(const Picture& picture, std::size_t pixel) {
  const std::uint8_t* rgb = picture.rgb.data() + 3 * pixel;
  return Vector3d(rgb[0], rgb[1], rgb[2]) / 255;
}

class BorderCounter {
 public:
  BorderCounter(const Scene& scene, const ColourGroups& groups, const VisionParameters& vision,
                Sight& sight)
      : groups_(groups), vision_(vision), in_(intrinsics_of(scene.studio)), sight_(sight) {}

  void count(const Picture& picture) const {
    const auto width = static_cast<std::size_t>(picture.width_px);
    for (std::size_t k = 0; k < picture.surface.size(); ++k) {
      if (picture.surface[k] == 0) continue;
      if ((k + 1) % width != 0) compare(picture, k, k + 1);
      if (k + width < picture.surface.size()) compare(picture, k, k + width);
    }
  }

 private:
  void compare(const Picture& picture, std::size_t a, std::size_t b) const {
    const std::uint16_t first = picture.surface[a], second = picture.surface[b];
    if (second == 0 || first == second) return;
    const double near = static_cast<double>(std::min(picture.depth[a], picture.depth[b]));
    const double far = static_cast<double>(std::max(picture.depth[a], picture.depth[b]));
    const double pixel = (in_.projection == Projection::kPerspective ? near : 1) / in_.fx_px;
    if (!(far - near <= kTouching_px * pixel)) return;
    const std::size_t one = groups_.group_of[first - 1U], other = groups_.group_of[second - 1U];
    if (one == other) ++sight_.alike_borders[std::minmax<std::size_t>(first - 1U, second - 1U)];
    if (!groups_.are_two(one, other)) return;
    const Vector3d colour = colour_at(picture, a), next = colour_at(picture, b);
    Border& border = sight_.borders[std::minmax(one, other)];
    const double darker = std::min(intensity_seen(colour, vision_), intensity_seen(next, vision_));
    if (darker <= vision_.intensity_min) return;
    const double separation = colour_separation(colour, next, vision_);
    if (border.pixels == 0 || separation < border.least_separation)
      border.least_separation = separation;
    ++border.pixels;
    if (separation < 1) ++border.merged;
  }

  const ColourGroups& groups_;
  const VisionParameters& vision_;
  Intrinsics in_;
  Sight& sight_;
};

// Sensors of other things than colours know no darkness.
bool is_dark(const Picture& picture, std::size_t pixel, const VisionParameters& vision) {
  if (vision.sensor != SensorKind::colour && vision.sensor != SensorKind::grey) return false;
  return intensity_seen(colour_at(picture, pixel), vision) < vision.intensity_min;
}

void count_pixels(const Picture& picture, const VisionParameters& vision, Sight& sight) {
  std::vector<std::size_t> pixels(sight.parts.size(), 0);
  for (std::size_t k = 0; k < picture.surface.size(); ++k) {
    if (picture.surface[k] == 0) continue;
    Sight::Part& part = sight.parts[picture.surface[k] - 1U];
    ++pixels[picture.surface[k] - 1U];
    ++part.seen_px;
    if (is_dark(picture, k, vision)) ++part.dark_px;
  }
  for (std::size_t k = 0; k < pixels.size(); ++k)
    sight.parts[k].most_px = std::max(sight.parts[k].most_px, pixels[k]);
}

// The contours with those parameters, of all primitives in sight.
std::map<int, double> contours_with(const Renderer& renderer, const Studio& studio,
                                    const VisionParameters& vision) {
  Observer observer(renderer, studio, vision);
  std::map<int, double> largest;
  for (const Vector3d& direction : examined_directions()) {
    const ObservedView view = observer.observe(direction);
    note_contours(view, observer.picture(), vision.sensor, largest);
  }
  return largest;
}

}  // namespace

ColourGroups colour_groups(const Scene& scene) {
  ColourGroups found;
  std::map<std::array<double, 3>, std::size_t> by_colour;
  for (const Primitive& primitive : scene.primitives) {
    const auto index = static_cast<std::size_t>(primitive.surface);
    const Surface& surface = scene.surfaces[index];
    if (surface.texture != nullptr) {
      found.group_of.push_back(ColourGroups::kNone);
      continue;
    }
    const Vector3d seen = colour_seen(scene, surface);
    const auto [at, added] =
        by_colour.try_emplace({seen.x(), seen.y(), seen.z()}, found.groups.size());
    if (added) found.groups.push_back({seen, {}});
    std::vector<std::size_t>& surfaces = found.groups[at->second].surfaces;
    if (std::find(surfaces.begin(), surfaces.end(), index) == surfaces.end())
      surfaces.push_back(index);
    found.group_of.push_back(at->second);
  }
  return found;
}

Sight look_around(const Scene& scene, const Renderer& renderer, const ColourGroups& groups,
                  const VisionParameters& vision, double distance) {
  Sight sight;
  sight.parts.resize(scene.primitives.size());
  Studio studio = scene.studio;
  studio.distance = distance;
  const BorderCounter counter(scene, groups, vision, sight);
  Observer observer(renderer, studio, vision);
  std::map<int, double> largest;
  for (const Vector3d& direction : examined_directions()) {
    const ObservedView view = observer.observe(direction);
    note_contours(view, observer.picture(), vision.sensor, largest);
    count_pixels(observer.picture(), vision, sight);
    counter.count(observer.picture());
  }
  bool some_lost = false;
  for (const auto& [primitive, pixels] : largest) {
    sight.parts[static_cast<std::size_t>(primitive) - 1].kept_px = pixels;
    some_lost = some_lost || pixels == 0;
  }
  if (!some_lost) return sight;
  VisionParameters with_thin = vision;
  with_thin.thickness_min_px = 0;
  for (const auto& [primitive, pixels] : contours_with(renderer, studio, with_thin))
    sight.parts[static_cast<std::size_t>(primitive) - 1].thin_px = pixels;
  return sight;
}

}  // namespace aspect
