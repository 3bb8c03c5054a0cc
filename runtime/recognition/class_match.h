// Matching a frame's contours with a class by contour types (thesis 3.5.1).
#pragma once

#include <cstdint>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/recognition/assignment.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

enum class Matching : std::uint8_t { simple, weighted };

struct ClassMatch {
  Assignment assignment;  // frame contour -> class contour
  // Simple: equation 3.8; weighted: equation 4.2. A float would lose weights below 0.5 next to the
  // 10^6 a match.
  double score = 0;
};

// Nearest contour type of a feature; ties go to the lower type. O(types).
std::uint16_t nearest_type(const ClassIndex& index, const ContourFeature& feature);

class ClassMatcher {
 public:
  // For most_matched() only.
  void prepare(Arena& arena, std::span<const ClassIndex> indexes);

  // Types of a frame's contours in one index; match() then works with these.
  void set_contours(const ClassIndex& index, std::span<const ContourFeature> features);

  // How many contours can be matched at the very most: those of a type that the class knows.
  int most_matched(std::size_t index_place, std::size_t class_id) const;

  ClassMatch match(const ClassIndex& index, std::size_t class_id, Matching matching);

 private:
  static constexpr std::size_t kWords = 4;  // of 64 types
  struct TypeSet {
    std::array<std::uint64_t, kWords> words{};
  };
  std::span<TypeSet> type_sets_;        // by class, indexes one after the other
  std::span<std::size_t> first_class_;  // of each index in type_sets_
  std::array<std::uint16_t, kMaxSide> types_{};
  std::size_t contour_count_ = 0;
  std::array<double, kMaxSide * kMaxSide> weights_{};
};

inline constexpr std::size_t kMaxTypes = 256;

}  // namespace aspect
