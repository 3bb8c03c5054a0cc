#include "runtime/recognition/class_match.h"

#include <algorithm>
#include <cstdlib>

namespace aspect {

std::uint16_t nearest_type(const ClassIndex& index, const ContourFeature& feature) {
  return nearest_type(index.types, type_attributes(feature));
}

void ClassMatcher::prepare(Arena& arena, std::span<const ClassIndex> indexes) {
  std::size_t classes = 0;
  for (const ClassIndex& index : indexes) classes += index.classes.size();
  type_sets_ = arena.take<TypeSet>(classes);
  first_class_ = arena.take<std::size_t>(indexes.size());
  if (type_sets_.empty() || first_class_.empty()) return;
  std::size_t place = 0;
  for (std::size_t i = 0; i < indexes.size(); ++i) {
    const ClassIndex& index = indexes[i];
    first_class_[i] = place;
    for (const AspectClass& aspect : index.classes) {
      TypeSet& set = type_sets_[place++];
      for (const ClassContour& contour : ClassIndex::part(index.class_contours, aspect.contours))
        for (const TypeScore& type : ClassIndex::part(index.type_scores, contour.types))
          set.words[type.type / 64U] |= std::uint64_t{1} << (type.type % 64U);
    }
  }
}

void ClassMatcher::set_contours(const ClassIndex& index, std::span<const ContourFeature> features) {
  contour_count_ = features.size();
  for (std::size_t i = 0; i < contour_count_; ++i) types_[i] = nearest_type(index, features[i]);
}

int ClassMatcher::most_matched(std::size_t index_place, std::size_t class_id) const {
  const TypeSet& set = type_sets_[first_class_[index_place] + class_id];
  int count = 0;
  for (std::size_t i = 0; i < contour_count_; ++i)
    count += static_cast<int>((set.words[types_[i] / 64U] >> (types_[i] % 64U)) & 1U);
  return count;
}

ClassMatch ClassMatcher::match(const ClassIndex& index, std::size_t class_id, Matching matching) {
  const AspectClass& aspect = index.classes[class_id];
  const auto contours = ClassIndex::part(index.class_contours, aspect.contours);
  // One match more outweighs every sum of scores, so that cardinality comes first.
  constexpr double kMatchWorth = 1e6;
  std::fill_n(weights_.begin(), contour_count_ * contours.size(), 0.0);
  for (std::size_t k = 0; k < contours.size(); ++k)
    for (const TypeScore& type : ClassIndex::part(index.type_scores, contours[k].types))
      for (std::size_t i = 0; i < contour_count_; ++i)
        if (types_[i] == type.type)
          weights_[i * contours.size() + k] =
              kMatchWorth + (matching == Matching::weighted ? static_cast<double>(type.score) : 0);
  ClassMatch match;
  assign(weights_, contour_count_, contours.size(), match.assignment);
  const double m = match.assignment.matched;
  const auto seen = static_cast<double>(contour_count_);
  const auto known = static_cast<double>(contours.size());
  if (matching == Matching::simple)
    match.score = 10 * m - std::abs(seen - known);
  else
    match.score = match.assignment.weight - 1e5 * std::max(known - seen, 0.0);
  return match;
}

}  // namespace aspect
