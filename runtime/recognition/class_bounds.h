// How badly the key views of a class, or of an object, must fit what is seen, without fitting any:
// what lets most of many objects be passed over. Exact bounds: no fit costs less.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/view_fit.h"

namespace aspect {

class ClassBounds {
 public:
  // `indexes` must outlive the bounds.
  void prepare(Arena& arena, std::span<const ClassIndex> indexes);

  // What is seen; at most kMaxSide contours.
  void set_contours(std::span<const ContourFeature> seen);

  // What it costs to match nothing at all.
  float most_cost() const { return most_cost_; }

  // Of any key view of the index: by its colours alone. O(seen x colours).
  float least_cost(std::size_t index) const;

  // Of any key view of the class: by colours, and between which areas and distances from the
  // centre its contours are seen. O(seen x contours of the class).
  float least_cost(std::size_t index, std::size_t class_id) const;

 private:
  // A contour over the key views of its class.
  struct Range {
    std::array<float, 3> share{};
    float least_area = 0, most_area = 0, least_radius = 0, most_radius = 0;
  };
  struct ClassRange {
    std::uint32_t first = 0, count = 0;  // in ranges_
    std::uint32_t least_contours = 0;    // that a key view has
  };
  struct IndexRange {
    std::uint32_t first_class = 0;  // in classes_
    std::uint32_t first_share = 0, share_count = 0;
  };
  struct Seen {
    std::array<float, 3> share{};
    float area = 0, radius = 0, alone = 0;
  };
  void add_class(const ClassIndex& index, const AspectClass& aspect, ClassRange& range);

  std::span<Range> ranges_;
  std::span<ClassRange> classes_;
  std::span<IndexRange> indexes_;
  std::span<std::array<float, 3>> shares_;  // distinct ones of each index
  std::array<Seen, kMaxSide> seen_{};
  std::size_t seen_count_ = 0, range_count_ = 0;
  float most_cost_ = 0;
  ViewFitScales scales_;
};

}  // namespace aspect
