// Class indexes made by hand, and features that are of a wanted contour type in them.
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "runtime/recognition/class_match.h"

namespace aspect {

ContourFeature random_feature(std::mt19937& random);

using MadeContour = std::vector<std::pair<std::uint16_t, float>>;  // types and their scores
using MadeClass = std::vector<MadeContour>;

struct MadeIndex {
  ClassIndex index;
  std::vector<ContourFeature> feature_of_type;

  std::vector<ContourFeature> features(const std::vector<std::size_t>& types) const;
};

// `types` contour types, each the attributes of a feature, and the classes.
MadeIndex made_index(std::size_t types, const std::vector<MadeClass>& classes);

// A matcher with the memory that it needs.
class OwnedMatcher {
 public:
  explicit OwnedMatcher(const ClassIndex& index);
  ClassMatch match(const std::vector<ContourFeature>& features, std::size_t class_id,
                   Matching matching);
  int most_matched(std::size_t class_id) const { return matcher_.most_matched(0, class_id); }

 private:
  const ClassIndex& index_;
  PlannedMemory memory_;
  ClassMatcher matcher_;
};

}  // namespace aspect
