// Which surfaces of an object are seen beside each other, and how: pairs of contours of its key
// views by their colours, and by two ratios that neither place nor distance nor roll change.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

struct RegionPair {
  std::uint32_t key_view = 0;
  std::uint8_t first = 0, second = 0;  // its contours
  // Area / squared distance of the centres.
  float first_size = 0, second_size = 0;
};

// One contour alone.
struct KeyRegion {
  std::uint32_t key_view = 0;
  std::uint32_t contour = 0;  // into ClassIndex::key_contours
};

class RegionPairs {
 public:
  // Contours of less than a hundredth of their view are left out. O(pairs).
  void prepare(Arena& arena, const ClassIndex& index);

  // Of contours of these colours of the model, in this order: first <= second.
  std::span<const RegionPair> of(ColourClass first, ColourClass second) const;

  // Contours of a colour of the model, of a hundredth of their view at least.
  std::span<const KeyRegion> of(ColourClass colour) const;

  // By the place of a contour in ClassIndex::key_contours; kBackgroundClass: none.
  ColourClass colour_of(std::size_t key_contour) const { return colours_[key_contour]; }

 private:
  void sort_regions(const ClassIndex& index);
  std::size_t bucket(ColourClass first, ColourClass second) const {
    return static_cast<std::size_t>(first - 1) * colour_count_ + second - 1U;
  }

  std::size_t colour_count_ = 0;
  std::span<ColourClass> colours_;
  std::span<std::uint32_t> begins_;  // of pairs, by bucket, and the end
  std::span<RegionPair> pairs_;
  std::span<std::uint32_t> region_begins_;  // by colour, and the end
  std::span<KeyRegion> regions_;
};

// The model's colour nearest to a share; kBackgroundClass where none is near.
ColourClass nearest_colour(const ObjectModel& model, const std::array<float, 3>& share);

}  // namespace aspect
