#include "compiler/aspects/colour_separation.h"

#include <algorithm>
#include <cmath>

namespace aspect {
namespace {

constexpr int kAnyIntensityStep = 765;

// As the grey sensor weighs colours, ITU-R BT.601, and as the segmentation counts it: r + g + b.
double grey_intensity(const Eigen::Vector3d& colour) {
  return 3 * 255 * Eigen::Vector3d(77, 150, 29).dot(colour) / 256;
}

ColourGap grey_gap(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const VisionParameters& vision) {
  const double first = grey_intensity(a), second = grey_intensity(b);
  const double step = std::max(vision.intensity_step, 1);
  if (!(std::min(first, second) > vision.intensity_min)) return {0, step};
  return {std::abs(first - second), step};
}

}  // namespace

Eigen::Vector3d colour_seen(const Scene& scene, const Surface& surface) {
  const Eigen::Vector3d ambient = surface.ambient.cwiseProduct(scene.studio.ambient);
  return scene.lights.empty() ? ambient : Eigen::Vector3d(ambient + surface.diffuse);
}

ColourGap colour_gap(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const VisionParameters& vision) {
  if (vision.sensor == SensorKind::grey) return grey_gap(a, b, vision);
  const double sum_a = a.sum(), sum_b = b.sum();
  const double darker = 255 * std::min(sum_a, sum_b);
  const double step = vision.chroma_step + vision.noise_steps * 255 / std::max(darker, 1.0);
  if (!(darker > vision.intensity_min)) return {0, step};
  const ColourGap shares{255 * (a / sum_a - b / sum_b).cwiseAbs().maxCoeff(), step};
  const ColourGap brightness{255 * std::abs(sum_a - sum_b),
                             static_cast<double>(std::max(vision.intensity_step, 1))};
  const bool by_brightness =
      vision.intensity_step < kAnyIntensityStep && brightness.separation() > shares.separation();
  return by_brightness ? brightness : shares;
}

double colour_separation(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const VisionParameters& vision) {
  return colour_gap(a, b, vision).separation();
}

}  // namespace aspect
