#include "runtime/recognition/class_bounds.h"

#include <algorithm>
#include <limits>

#include "runtime/base/portable_math.h"
#include "runtime/recognition/seen_colours.h"

namespace aspect {
namespace {

// Fits round where bounds do not.
constexpr float kRounding = 1 - 1e-4F;

float square(float x) {
  return x * x;
}

// How far a value is from the nearest one of a range.
float distance_to(float value, float least, float most) {
  return std::max({least - value, value - most, 0.0F});
}

}  // namespace

void ClassBounds::prepare(Arena& arena, std::span<const ClassIndex> indexes) {
  std::size_t classes = 0, contours = 0;
  for (const ClassIndex& index : indexes) {
    classes += index.classes.size();
    contours += index.class_contours.size();
  }
  ranges_ = arena.take<Range>(contours);
  classes_ = arena.take<ClassRange>(classes);
  indexes_ = arena.take<IndexRange>(indexes.size());
  shares_ = arena.take<std::array<float, 3>>(contours);
  if (indexes_.empty() || classes_.size() < classes || ranges_.size() < contours) return;
  range_count_ = 0;
  std::size_t class_count = 0, share_count = 0;
  for (std::size_t i = 0; i < indexes.size(); ++i) {
    const ClassIndex& index = indexes[i];
    indexes_[i] = {static_cast<std::uint32_t>(class_count), static_cast<std::uint32_t>(share_count),
                   0};
    const std::size_t first_range = range_count_;
    for (const AspectClass& aspect : index.classes)
      add_class(index, aspect, classes_[class_count++]);
    for (const Range& range : ranges_.subspan(first_range, range_count_ - first_range)) {
      const auto own = shares_.subspan(indexes_[i].first_share, indexes_[i].share_count);
      if (std::find(own.begin(), own.end(), range.share) != own.end()) continue;
      shares_[share_count++] = range.share;
      ++indexes_[i].share_count;
    }
  }
}

void ClassBounds::add_class(const ClassIndex& index, const AspectClass& aspect,
                            ClassRange& of_class) {
  const auto contours = ClassIndex::part(index.class_contours, aspect.contours);
  const std::size_t first = range_count_;
  for (const ClassContour& contour : contours) {
    constexpr float kNone = std::numeric_limits<float>::infinity();
    ranges_[range_count_++] = {contour.share, kNone, -kNone, kNone, -kNone};
  }
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  for (const KeyView& view : ClassIndex::part(index.key_views, aspect.key_views)) {
    least = std::min(least, view.contours.count);
    for (const KeyContour& contour : ClassIndex::part(index.key_contours, view.contours)) {
      Range& range = ranges_[first + contour.name];
      const float area = contour.feature.area,
                  radius = portable_hypot(contour.feature.position.x, contour.feature.position.y);
      range.least_area = std::min(range.least_area, area);
      range.most_area = std::max(range.most_area, area);
      range.least_radius = std::min(range.least_radius, radius);
      range.most_radius = std::max(range.most_radius, radius);
    }
  }
  // What no key view shows matches nothing.
  const auto of_it = ranges_.subspan(first, range_count_ - first);
  range_count_ =
      first + static_cast<std::size_t>(
                  std::remove_if(of_it.begin(), of_it.end(),
                                 [](const Range& r) { return r.least_area > r.most_area; }) -
                  of_it.begin());
  of_class = {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(range_count_ - first),
              aspect.key_views.count == 0 ? 0 : least};
}

void ClassBounds::set_contours(std::span<const ContourFeature> seen) {
  seen_count_ = std::min(seen.size(), kMaxSide);
  most_cost_ = 0;
  for (std::size_t i = 0; i < seen_count_; ++i) {
    const ContourFeature& feature = seen[i];
    seen_[i] = {feature.share, feature.area, portable_hypot(feature.position.x, feature.position.y),
                scales_.alone(feature.area)};
    most_cost_ += seen_[i].alone;
  }
}

float ClassBounds::least_cost(std::size_t index) const {
  const IndexRange& of_index = indexes_[index];
  const auto shares = shares_.subspan(of_index.first_share, of_index.share_count);
  const float unit = square(scales_.share);
  float total = 0;
  for (std::size_t i = 0; i < seen_count_; ++i) {
    float least = seen_[i].alone * unit;
    for (const std::array<float, 3>& share : shares)
      least = std::min(least, squared_distance(seen_[i].share, share));
    total += least / unit;
  }
  return total * kRounding;
}

float ClassBounds::least_cost(std::size_t index, std::size_t class_id) const {
  const ClassRange& of_class = classes_[indexes_[index].first_class + class_id];
  const auto ranges = ranges_.subspan(of_class.first, of_class.count);
  // Key contours that are more than those seen stay alone.
  float total = of_class.least_contours > seen_count_
                    ? scales_.missing * static_cast<float>(of_class.least_contours - seen_count_)
                    : 0;
  for (std::size_t i = 0; i < seen_count_; ++i) {
    const Seen& seen = seen_[i];
    float least = seen.alone;
    for (const Range& range : ranges) {
      const float cost =
          squared_distance(seen.share, range.share) / square(scales_.share) +
          square(distance_to(seen.area, range.least_area, range.most_area) / scales_.area) +
          square(distance_to(seen.radius, range.least_radius, range.most_radius) /
                 scales_.position);
      least = std::min(least, cost);
    }
    total += least;
  }
  return total * kRounding;
}

}  // namespace aspect
