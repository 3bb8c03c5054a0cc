#include "runtime/recognition/region_pairs.h"

#include <algorithm>

#include "runtime/recognition/seen_colours.h"

namespace aspect {
namespace {

constexpr float kLeastArea = 0.01F;
// Centres nearer than this, in square roots of the blob's area, give no direction.
constexpr float kLeastDistance = 0.05F;

// Calls `see(key view, first, second)` for each pair, the contour of the lower colour first.
template <typename See>
void each_pair(const ClassIndex& index, std::span<const ColourClass> colours, See see) {
  for (std::size_t v = 0; v < index.key_views.size(); ++v) {
    const IndexRange range = index.key_views[v].contours;
    const auto contours = ClassIndex::part(index.key_contours, range);
    const std::size_t count = std::min<std::size_t>(contours.size(), 255);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) {
        const ContourFeature &a = contours[i].feature, &b = contours[j].feature;
        const ColourClass of_a = colours[range.first + i], of_b = colours[range.first + j];
        const float dx = b.position.x - a.position.x, dy = b.position.y - a.position.y;
        if (of_a == kBackgroundClass || of_b == kBackgroundClass) continue;
        if (std::min(a.area, b.area) < kLeastArea ||
            dx * dx + dy * dy < kLeastDistance * kLeastDistance)
          continue;
        if (of_a <= of_b)
          see(v, i, j);
        else
          see(v, j, i);
      }
  }
}

template <typename See>
void each_region(const ClassIndex& index, std::span<const ColourClass> colours, See see) {
  for (std::size_t v = 0; v < index.key_views.size(); ++v) {
    const IndexRange range = index.key_views[v].contours;
    for (std::uint32_t k = range.first; k < range.first + range.count; ++k)
      if (colours[k] != kBackgroundClass && index.key_contours[k].feature.area >= kLeastArea)
        see(static_cast<std::uint32_t>(v), k);
  }
}

void add_up(std::span<std::uint32_t> counts) {
  for (std::size_t k = 1; k < counts.size(); ++k) counts[k] += counts[k - 1];
}

}  // namespace

ColourClass nearest_colour(const ObjectModel& model, const std::array<float, 3>& share) {
  const std::size_t nearest = nearest_share(model.shares, share);
  return nearest == model.shares.size() ? kBackgroundClass : static_cast<ColourClass>(nearest + 1);
}

void RegionPairs::prepare(Arena& arena, const ClassIndex& index) {
  colour_count_ = index.model.shares.size();
  std::vector<ColourClass> colours(index.key_contours.size());
  for (std::size_t k = 0; k < colours.size(); ++k)
    colours[k] = nearest_colour(index.model, index.key_contours[k].feature.share);
  std::size_t count = 0;
  each_pair(index, colours, [&](std::size_t, std::size_t, std::size_t) { ++count; });
  colours_ = arena.take<ColourClass>(colours.size());
  begins_ = arena.take<std::uint32_t>(colour_count_ * colour_count_ + 1);
  pairs_ = arena.take<RegionPair>(count);
  std::size_t region_count = 0;
  each_region(index, colours, [&](std::uint32_t, std::uint32_t) { ++region_count; });
  region_begins_ = arena.take<std::uint32_t>(colour_count_ + 1);
  regions_ = arena.take<KeyRegion>(region_count);
  if (colours_.size() != colours.size() || pairs_.size() != count || begins_.empty()) return;
  std::copy(colours.begin(), colours.end(), colours_.begin());
  sort_regions(index);
  const auto bucket_of = [&](std::size_t view, std::size_t i, std::size_t j) {
    const std::size_t first = index.key_views[view].contours.first;
    return bucket(colours[first + i], colours[first + j]);
  };
  each_pair(index, colours, [&](std::size_t v, std::size_t i, std::size_t j) {
    ++begins_[bucket_of(v, i, j) + 1];
  });
  add_up(begins_);
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end());
  each_pair(index, colours, [&](std::size_t v, std::size_t i, std::size_t j) {
    const auto contours = ClassIndex::part(index.key_contours, index.key_views[v].contours);
    const ContourFeature &a = contours[i].feature, &b = contours[j].feature;
    const float dx = b.position.x - a.position.x, dy = b.position.y - a.position.y;
    pairs_[next[bucket_of(v, i, j)]++] = {
        static_cast<std::uint32_t>(v), static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
        a.area / (dx * dx + dy * dy), b.area / (dx * dx + dy * dy)};
  });
}

void RegionPairs::sort_regions(const ClassIndex& index) {
  each_region(index, colours_,
              [&](std::uint32_t, std::uint32_t k) { ++region_begins_[colours_[k]]; });
  add_up(region_begins_);
  std::vector<std::uint32_t> next(region_begins_.begin(), region_begins_.end());
  each_region(index, colours_, [&](std::uint32_t view, std::uint32_t k) {
    regions_[next[colours_[k] - 1U]++] = {view, k};
  });
}

std::span<const KeyRegion> RegionPairs::of(ColourClass colour) const {
  const std::uint32_t first = region_begins_[colour - 1U];
  return std::span<const KeyRegion>(regions_).subspan(first, region_begins_[colour] - first);
}

std::span<const RegionPair> RegionPairs::of(ColourClass first, ColourClass second) const {
  const std::size_t b = bucket(first, second);
  return std::span<const RegionPair>(pairs_).subspan(begins_[b], begins_[b + 1] - begins_[b]);
}

}  // namespace aspect
