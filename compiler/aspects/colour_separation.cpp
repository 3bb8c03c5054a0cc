#include "compiler/aspects/colour_separation.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

constexpr int kAnyIntensityStep = 765;

}  // namespace

Eigen::Vector3d colour_seen(const Scene& scene, const Surface& surface) {
  const Eigen::Vector3d ambient = surface.ambient.cwiseProduct(scene.studio.ambient);
  return scene.lights.empty() ? ambient : Eigen::Vector3d(ambient + surface.diffuse);
}

double intensity_seen(const Eigen::Vector3d& colour, const VisionParameters& vision) {
  if (vision.sensor != SensorKind::grey) return 255 * colour.sum();
  // As the grey sensor weighs colours, ITU-R BT.601.
  return 3 * 255 * Eigen::Vector3d(77, 150, 29).dot(colour) / 256;
}

ColourGap colour_gap(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const VisionParameters& vision) {
  const double first = intensity_seen(a, vision), second = intensity_seen(b, vision);
  const double darker = std::min(first, second);
  const bool is_seen = darker > vision.intensity_min;
  const ColourGap brightness{is_seen ? std::abs(first - second) : 0,
                             static_cast<double>(std::max(vision.intensity_step, 1))};
  if (vision.sensor == SensorKind::grey) return brightness;
  const double step = vision.chroma_step + vision.noise_steps * 255 / std::max(darker, 1.0);
  if (!is_seen) return {0, step};
  const ColourGap shares{255 * (a / a.sum() - b / b.sum()).cwiseAbs().maxCoeff(), step};
  const bool by_brightness = vision.intensity_step > 0 &&
                             vision.intensity_step < kAnyIntensityStep &&
                             brightness.separation() > shares.separation();
  return by_brightness ? brightness : shares;
}

double colour_separation(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const VisionParameters& vision) {
  return colour_gap(a, b, vision).separation();
}

}  // namespace aspect
