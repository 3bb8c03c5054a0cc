#include "runtime/vision/vision.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "runtime/vision/attributes.h"
#include "runtime/vision/brightness_edges.h"
#include "runtime/vision/enhance.h"
#include "runtime/vision/relations.h"
#include "runtime/vision/sensor_colour.h"
#include "runtime/vision/surface_codes.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {

namespace {

using Clock = std::chrono::steady_clock;

// Moves the `most` largest contours to the front, in the order that they are in, and returns how
// many there are.
std::size_t keep_largest(std::span<Contour> contours, std::size_t most) {
  if (contours.size() <= most) return contours.size();
  std::array<std::uint16_t, 2 * kMaxRegions> indices;
  const auto order = std::span(indices).first(contours.size());
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(most);
  std::nth_element(order.begin(), end, order.end(), [&](std::uint16_t a, std::uint16_t b) {
    const float area_a = contours[a].area_px, area_b = contours[b].area_px;
    return area_a != area_b ? area_a > area_b : a < b;
  });
  std::sort(order.begin(), end);
  // None moves towards the end, so none is overwritten before it has moved.
  for (std::size_t k = 0; k < most; ++k) contours[k] = contours[order[k]];
  return most;
}

// What segmentation goes by: codes have no intensities, and regions whose cores do not touch are
// one only where their codes are the same to the last steps.
VisionParameters cutting_parameters(VisionParameters parameters, const Planes& planes) {
  constexpr int kSamePlaneSteps = 2, kAnyIntensity = 765;
  const bool range = parameters.sensor == SensorKind::range;
  if (parameters.intensity_step == 0)
    parameters.intensity_step = measured_intensity_step(planes, parameters.intensity_min);
  if (!range && parameters.sensor != SensorKind::surface) return parameters;
  parameters.chroma_step = range ? kSamePlaneSteps : 0;
  parameters.intensity_step = kAnyIntensity;
  return parameters;
}

void colour_contours(SensorKind sensor, std::span<Contour> contours) {
  switch (sensor) {
    case SensorKind::colour:
      return;
    case SensorKind::grey:
      return colour_by_grey(contours);
    case SensorKind::range:
      return colour_alike(contours);
    case SensorKind::surface:
      return colour_by_surface(contours);
  }
}

}  // namespace

void Vision::prepare(Arena& arena, int width_px, int height_px, SensorKind sensor) {
  sensor_ = sensor;
  width_px_ = std::min(width_px, kMaxFrameSide_px);
  height_px_ = std::min(height_px, kMaxFrameSide_px);
  colours_ = sensor == SensorKind::grey ? take_grey_planes(arena, width_px_, height_px_)
                                        : take_planes(arena, width_px_, height_px_);
  if (sensor == SensorKind::range || sensor == SensorKind::surface) {
    masks_ = take_code_masks(arena, width_px_, height_px_);
  } else {
    bands_.take(arena, width_px_);
  }
  if (sensor == SensorKind::range) {
    codes_ = take_planes(arena, width_px_, height_px_);
    scratch_ = arena.take<std::uint8_t>(kMedianRows * static_cast<std::size_t>(width_px_));
    range_codes_.take(arena, width_px_, height_px_);
  }
  segmenter_.take(arena, width_px_, height_px_);
  tracer_.take(arena, width_px_, height_px_);
  contours_ = arena.take<Contour>(2 * kMaxRegions);
  relations_ = arena.take<Relation>(kMaxRelations);
  blobs_ = arena.take<Blob>(kMaxBlobs);
}

ViewGraph Vision::run(const Frame& frame, const VisionParameters& parameters) noexcept {
  times_ = {};
  regions_ = {};
  if (!can_see(frame, parameters)) return {};
  const bool has_colours = sensor_ == SensorKind::colour || sensor_ == SensorKind::grey;
  if (!(has_colours ? see_colours(frame, parameters) : see_codes(frame, parameters))) return {};
  const auto enhanced = Clock::now();
  regions_ = segmenter_.run(enhanced_, cutting_parameters(parameters, colours_));
  regions_.looked_at = part_looked_at(frame, parameters);
  const auto segmented = Clock::now();
  const ViewGraph graph = build_graph(parameters);
  times_.segment = segmented - enhanced;
  times_.features = Clock::now() - segmented;
  return graph;
}

bool Vision::look(const Frame& frame, const VisionParameters& parameters) noexcept {
  times_ = {};
  regions_ = {};
  return can_see(frame, parameters) && sensor_ == SensorKind::colour &&
         see_colours(frame, parameters);
}

bool Vision::can_see(const Frame& frame, const VisionParameters& parameters) const {
  return is_whole(frame) && frame.width_px <= width_px_ && frame.height_px <= height_px_ &&
         parameters.sensor == sensor_ && gives(sensor_, frame.format);
}

// False where the frame shows nothing.
bool Vision::see_colours(const Frame& frame, const VisionParameters& parameters) {
  const auto start = Clock::now();
  const Box box = foreground_box(frame, parameters);
  const auto found = Clock::now();
  if (box.empty()) return false;
  bands_.run(frame, box, parameters.smooth, colours_);
  enhanced_ = {colours_, nullptr, 0};
  times_.convert = found - start + bands_.converting();
  times_.enhance = bands_.smoothing();
  return true;
}

// Likewise. Ids are no quantities: there is nothing between two of them to smooth.
bool Vision::see_codes(const Frame& frame, const VisionParameters& parameters) {
  const auto start = Clock::now();
  const bool range = sensor_ == SensorKind::range, smooths = range && parameters.smooth;
  Planes& raw = smooths ? codes_ : colours_;
  const bool shows = range ? range_codes_.run(frame, parameters, raw, masks_)
                           : find_surface_codes(frame, parameters, raw, masks_);
  if (!shows) return false;
  const auto converted = Clock::now();
  if (smooths) smooth(codes_, scratch_, colours_);
  const std::uint8_t step = range ? code_step(parameters.range.normal_step_deg) : std::uint8_t{0};
  enhanced_ = {colours_, &masks_, step};
  times_.convert = converted - start;
  times_.enhance = Clock::now() - converted;
  return true;
}

ViewGraph Vision::build_graph(const VisionParameters& parameters) {
  int dropped = regions_.dropped_regions;
  tracer_.lend(segmenter_.idle_memory());
  const std::span<const TracedContour> traced =
      tracer_.run(regions_, parameters.area_min_px, dropped);
  std::copy(regions_.blobs.begin(), regions_.blobs.end(), blobs_.begin());
  const auto blobs = blobs_.first(regions_.blobs.size());
  std::size_t contour_count = 0, relation_count = 0;
  for (std::size_t k = 0; k < blobs.size(); ++k) {
    Blob& blob = blobs[k];
    const std::size_t first = contour_count;
    for (const TracedContour& contour : traced) {
      if (regions_.regions[contour.label - 1U].blob != static_cast<int>(k)) continue;
      contours_[contour_count++] = describe(regions_, contour);
    }
    const auto found = contours_.subspan(first, contour_count - first);
    const auto own = found.first(keep_largest(found, kMaxBlobContours));
    dropped += static_cast<int>(found.size() - own.size());
    contour_count = first + own.size();
    colour_contours(parameters.sensor, own);
    blob.first_contour = static_cast<int>(first);
    blob.contour_count = static_cast<int>(own.size());
    blob.first_relation = static_cast<int>(relation_count);
    blob.relation_count = relate(own, parameters.relation_choice, parameters.relations_max,
                                 relations_.subspan(relation_count));
    relation_count += static_cast<std::size_t>(blob.relation_count);
  }
  return {contours_.first(contour_count), relations_.first(relation_count), blobs, dropped};
}

}  // namespace aspect
