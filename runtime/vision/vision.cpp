#include "runtime/vision/vision.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "runtime/vision/attributes.h"
#include "runtime/vision/relations.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {

namespace {

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

}  // namespace

void Vision::prepare(Arena& arena, int width_px, int height_px) {
  width_px_ = std::min(width_px, kMaxFrameSide_px);
  height_px_ = std::min(height_px, kMaxFrameSide_px);
  raw_ = take_planes(arena, width_px_, height_px_);
  smoothed_ = take_planes(arena, width_px_, height_px_);
  shares_ = take_shares(arena, width_px_, height_px_);
  scratch_ = arena.take<std::uint8_t>(3 * static_cast<std::size_t>(width_px_));
  segmenter_.take(arena, width_px_, height_px_);
  tracer_.take(arena, width_px_, height_px_);
  contours_ = arena.take<Contour>(2 * kMaxRegions);
  relations_ = arena.take<Relation>(kMaxRelations);
  blobs_ = arena.take<Blob>(kMaxBlobs);
}

ViewGraph Vision::run(const Frame& frame, const VisionParameters& parameters) noexcept {
  using Clock = std::chrono::steady_clock;
  times_ = {};
  regions_ = {};
  if (frame.data == nullptr || frame.width_px > width_px_ || frame.height_px > height_px_)
    return {};
  const auto start = Clock::now();
  const Box box = foreground_box(frame, parameters);
  if (box.empty()) return {};
  split_planes(frame, box, raw_);
  const auto converted = Clock::now();
  if (parameters.smooth) smooth(raw_, scratch_, smoothed_);
  const Planes& colours = parameters.smooth ? smoothed_ : raw_;
  normalise(colours, parameters, shares_);
  const auto enhanced = Clock::now();
  regions_ = segmenter_.run(colours, shares_, parameters);
  const auto segmented = Clock::now();
  const ViewGraph graph = build_graph(parameters);
  times_ = {converted - start, enhanced - converted, segmented - enhanced,
            Clock::now() - segmented};
  return graph;
}

ViewGraph Vision::build_graph(const VisionParameters& parameters) {
  int dropped = regions_.dropped_regions;
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
