#include "runtime/service/segmentation_values.h"

#include <algorithm>
#include <array>

#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

using Overrides = SegmentationOverrides;
constexpr double kMostPixels = static_cast<double>(kMaxFrameSide_px) * kMaxFrameSide_px;

constexpr std::array kValues = {
    SegmentationValue{"intensity_min", "r + g + b", "pixels that are darker are background",
                      "48 for black, 150 cuts away dark clutter, and dark parts of the object with "
                      "it",
                      0, 765, &Overrides::intensity_min},
    SegmentationValue{"chroma_step", "of 255",
                      "largest step of a colour share between neighbouring pixels of a region",
                      "6 to 16; higher joins alike colours, lower breaks up noisy surfaces", 1, 255,
                      &Overrides::chroma_step},
    SegmentationValue{"noise_steps", "",
                      "added to chroma_step in dark pixels, in multiples of one grey value's error",
                      "0 without noise, 3 for cameras; higher joins dark colours", 0, 255,
                      &Overrides::noise_steps},
    SegmentationValue{"intensity_step", "r + g + b",
                      "largest step of brightness between neighbouring pixels of a region",
                      "0: as the picture's noise allows, 15 to 90; higher joins what shading "
                      "parts, 765: any",
                      0, 765, &Overrides::intensity_step},
    SegmentationValue{"area_min_px", "px", "smaller regions are discarded",
                      "40 at 512 x 512; lower sees finer detail and more noise", 1, kMostPixels,
                      &Overrides::area_min_px},
    SegmentationValue{"thickness_min_px", "px", "thinner filaments are discarded",
                      "5; lower sees finer detail, but the pixel grid breaks thin slivers up", 0,
                      kMaxFrameSide_px, &Overrides::thickness_min_px},
    SegmentationValue{"smooth", "", "3 x 3 median before anything",
                      "removes noise for a third of the time", 0, 1, &Overrides::smooth},
    SegmentationValue{"one_blob", "", "all foreground is one object, however many pieces it is in",
                      "for a single object whose parts are apart, before something dark", 0, 1,
                      &Overrides::one_blob},
    SegmentationValue{"range_step_length", "scene units",
                      "length of one step of a range sensor's depths",
                      "0.001 where it counts in millimetres of a scene in metres", 1e-9, 1e9,
                      &Overrides::range_step_length, true},
    SegmentationValue{"range_steps_min", "steps", "nearer depths of a range sensor are background",
                      "", 1, 65534, &Overrides::range_steps_min, true},
    SegmentationValue{"range_steps_max", "steps", "farther depths of a range sensor are background",
                      "cuts away what stands behind", 1, 65534, &Overrides::range_steps_max, true},
    SegmentationValue{"range_depth_step", "of the distance",
                      "a wider gap between neighbouring depths parts two surfaces",
                      "0.01; lower sees shallower steps, until noise does", 1e-5, 1,
                      &Overrides::range_depth_step, true},
    SegmentationValue{"range_normal_step_deg", "degrees",
                      "surfaces of a range picture that meet at less are one",
                      "12; lower tells flatter edges, until round surfaces fall apart", 1, 90,
                      &Overrides::range_normal_step_deg, true},
};

}  // namespace

std::span<const SegmentationValue> segmentation_values() {
  return kValues;
}

const SegmentationValue* find_segmentation_value(std::string_view key) {
  const auto* const found = std::ranges::find(kValues, key, &SegmentationValue::key);
  return found == kValues.end() ? nullptr : found;
}

SegmentationOverrides segmentation_of(const VisionParameters& parameters) {
  SegmentationOverrides all;
  all.intensity_min = parameters.intensity_min;
  all.chroma_step = parameters.chroma_step;
  all.noise_steps = parameters.noise_steps;
  all.intensity_step = parameters.intensity_step;
  all.area_min_px = parameters.area_min_px;
  all.thickness_min_px = parameters.thickness_min_px;
  all.smooth = parameters.smooth;
  all.one_blob = parameters.one_blob;
  all.range_step_length = parameters.range.step_length;
  all.range_steps_min = parameters.range.steps_min;
  all.range_steps_max = parameters.range.steps_max;
  all.range_depth_step = parameters.range.depth_step;
  all.range_normal_step_deg = parameters.range.normal_step_deg;
  return all;
}

}  // namespace aspect
