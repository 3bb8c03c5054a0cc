#include "compiler/index/calibration.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "compiler/render/camera.h"
#include "compiler/render/made_frame.h"
#include "runtime/recognition/sized_recogniser.h"

namespace aspect {
namespace {

constexpr std::size_t kViews = 64;

// Pixels of one surface that is seen in the colour of another of the object's, as light as before.
void repaint(MadeFrame& frame, const Picture& picture, const Scene& scene, Dice& dice) {
  const auto paint_of = [&](std::size_t primitive) -> const Eigen::Vector3d& {
    return scene.surfaces[static_cast<std::size_t>(scene.primitives[primitive].surface)].diffuse;
  };
  std::vector<std::uint16_t> seen;
  for (const std::uint16_t surface : picture.surface)
    if (surface != 0 && (seen.empty() || seen.back() != surface)) seen.push_back(surface);
  if (seen.empty()) return;
  const std::uint16_t changed = seen[dice.below(seen.size())];
  const Eigen::Vector3d& colour = paint_of(dice.below(scene.primitives.size()));
  const auto whole = static_cast<float>(std::max(1e-6, colour.sum()));
  for (std::size_t k = 0; k < picture.surface.size(); ++k) {
    if (picture.surface[k] != changed) continue;
    float* rgb = &frame.rgb[3 * k];
    const float light = rgb[0] + rgb[1] + rgb[2];
    for (std::size_t c = 0; c < 3; ++c)
      rgb[c] = std::min(255.0F,
                        light * static_cast<float>(colour[static_cast<Eigen::Index>(c)]) / whole);
  }
}

void turn_colours(MadeFrame& frame) {
  for (std::size_t k = 0; k < frame.rgb.size(); k += 3)
    std::rotate(&frame.rgb[k], &frame.rgb[k + 1], &frame.rgb[k] + 3);
}

// Share of the object's pixels whose share of light of a colour changed.
double changed_share(const MadeFrame& before, const MadeFrame& after) {
  std::size_t object = 0, changed = 0;
  for (std::size_t k = 0; k < before.rgb.size(); k += 3) {
    const float sum = before.rgb[k] + before.rgb[k + 1] + before.rgb[k + 2];
    const float now = after.rgb[k] + after.rgb[k + 1] + after.rgb[k + 2];
    if (!(sum > 0) || !(now > 0)) continue;
    ++object;
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(before.rgb[k + c] / sum - after.rgb[k + c] / now) > 0.06F) {
        ++changed;
        break;
      }
  }
  return object > 0 ? static_cast<double>(changed) / static_cast<double>(object) : 0;
}

// So many times narrower, in a frame of the same size.
MadeFrame narrowed(const MadeFrame& frame, double times) {
  MadeFrame narrow{frame.width_px, frame.height_px, {}};
  narrow.rgb.assign(frame.rgb.size(), 0);
  const double left = frame.width_px * (1 - 1 / times) / 2;
  for (int y = 0; y < frame.height_px; ++y)
    for (int x = 0; x < frame.width_px; ++x) {
      const double from = (x + 0.5 - left) * times - 0.5;
      const int low = static_cast<int>(std::floor(from));
      if (low < 0 || low + 1 >= frame.width_px) continue;
      const auto share = static_cast<float>(from - low);
      const float* a = &frame.rgb[3 * static_cast<std::size_t>(y * frame.width_px + low)];
      for (std::size_t c = 0; c < 3; ++c)
        narrow.at(x, y)[c] = (1 - share) * a[c] + share * a[c + 3];
    }
  return narrow;
}

float best_agreement(const Recognition& seen) {
  float best = 0;
  for (const SeenObject& object : seen.objects)
    if (!object.hypotheses.empty() && object.hypotheses[0].pose != nullptr)
      best = std::max(best, object.hypotheses[0].pose->agreement.all_but_rims);
  return best;
}

// The frame's parameters are the index's: a default one asks for nothing else.
RecogniserParameters parameters_of(const ClassIndex& index) {
  RecogniserParameters parameters;
  parameters.vision = index.vision;
  parameters.anywhere = false;  // of what stands alone
  return parameters;
}

std::array<std::optional<CalibrationSample>, 2> samples_of(const Workshop& workshop,
                                                           const Scene& scene,
                                                           SizedRecogniser& recogniser,
                                                           std::size_t view) {
  Dice dice(view + 1);
  Picture picture;
  const Eigen::Vector3d direction = dice.direction();
  const double distance = workshop.studio.distance * dice.between(1, 2.5);
  workshop.renderer.render(camera_at(workshop.studio, direction, distance), picture);
  MadeFrame object{picture.width_px, picture.height_px, {}};
  object.rgb.assign(picture.rgb.begin(), picture.rgb.end());
  MadeFrame other = object;
  // One surface of another colour, other proportions, all colours others.
  constexpr double kChanged = 0.1;
  double stretch = 1;
  if (view % 4 == 3)
    turn_colours(other);
  else if (view % 4 == 1)
    stretch = dice.between(1.25, 1.5);
  else
    repaint(other, picture, scene, dice);
  const bool is_other = stretch > 1 || changed_share(object, other) > kChanged;
  recogniser.make_room(picture.width_px, picture.height_px);
  const auto agreement_in = [&](const MadeFrame& frame, double narrower) {
    const std::vector<std::uint8_t> rgb =
        photographed(narrower > 1 ? narrowed(frame, narrower) : frame, dice);
    return best_agreement(
        recogniser.recognise({rgb.data(), picture.width_px, picture.height_px,
                              std::ptrdiff_t{3} * picture.width_px, PixelFormat::rgb8}));
  };
  std::array<std::optional<CalibrationSample>, 2> samples;
  samples[0] = {agreement_in(object, 1), true};
  // One face in other proportions is the object's own, seen at a slant: no picture tells them
  // apart.
  constexpr float kSamePicture = 0.985F;
  if (!is_other) return samples;
  const float agreement = agreement_in(other, stretch);
  if (agreement < kSamePicture) samples[1] = {agreement, false};
  return samples;
}

double log_likelihood(std::span<const CalibrationSample> samples, double slope, double even) {
  double sum = 0;
  for (const CalibrationSample& sample : samples) {
    const double x = slope * (static_cast<double>(sample.agreement) - even);
    sum -= std::log1p(std::exp(sample.is_object ? -x : x));
  }
  return sum;
}

}  // namespace

Calibration likeliest_calibration(std::span<const CalibrationSample> samples) {
  Calibration best;
  double most = -1e300;
  for (int e = 0; e <= 45; ++e)
    for (const double slope : {20.0, 30.0, 45.0, 60.0, 80.0, 120.0, 180.0}) {
      const double even = 0.80 + 0.0045 * e, likelihood = log_likelihood(samples, slope, even);
      if (likelihood <= most) continue;
      most = likelihood;
      best = {static_cast<float>(slope), static_cast<float>(even)};
    }
  return best;
}

std::optional<Calibration> calibrated(const Workshop& workshop, const Scene& scene,
                                      const ClassIndex& index) {
  if (index.model.empty() || index.vision.sensor != SensorKind::colour) return std::nullopt;
  std::vector<std::array<std::optional<CalibrationSample>, 2>> found(kViews);
  tbb::enumerable_thread_specific<SizedRecogniser> recognisers(
      [&] { return SizedRecogniser(std::span(&index, 1), parameters_of(index)); });
  tbb::parallel_for(std::size_t{0}, kViews, [&](std::size_t view) {
    found[view] = samples_of(workshop, scene, recognisers.local(), view);
  });
  // What the frames made here are not: things that are like the object, and cameras worse than
  // these. Both count as a few frames more.
  std::vector<CalibrationSample> samples(4, {0.955F, false});
  samples.insert(samples.end(), 4, {0.985F, true});
  for (const auto& pair : found)
    for (const std::optional<CalibrationSample>& sample : pair)
      if (sample) samples.push_back(*sample);
  return likeliest_calibration(samples);
}

}  // namespace aspect
