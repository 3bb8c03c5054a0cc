#include "tests/runtime/recognition/made_index.h"

#include <memory>

namespace aspect {

ContourFeature random_feature(std::mt19937& random) {
  const auto number = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  ContourFeature f;
  const float red = number(0.1F, 0.5F), green = number(0.1F, 0.4F);
  f.share = {red, green, 1 - red - green};
  f.position = {number(-0.5F, 0.5F), number(-0.5F, 0.5F)};
  f.area = number(0.05F, 0.4F);
  f.moments = {number(0.08F, 0.2F),   number(-0.05F, 0.05F), number(0.08F, 0.2F),
               number(-0.01F, 0.01F), number(-0.01F, 0.01F), number(-0.01F, 0.01F),
               number(-0.01F, 0.01F)};
  return f;
}

std::vector<ContourFeature> MadeIndex::features(const std::vector<std::size_t>& types) const {
  std::vector<ContourFeature> found;
  for (const std::size_t type : types) found.push_back(feature_of_type[type]);
  return found;
}

MadeIndex made_index(std::size_t types, const std::vector<MadeClass>& classes) {
  MadeIndex made;
  std::mt19937 random(11);
  for (std::size_t k = 0; k < types; ++k) {
    made.feature_of_type.push_back(random_feature(random));
    made.index.types.push_back(type_attributes(made.feature_of_type.back()));
  }
  ClassIndex& index = made.index;
  const auto size = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  for (const MadeClass& contours : classes) {
    AspectClass aspect;
    aspect.contours = {size(index.class_contours), size(contours)};
    aspect.view = {0, 0, 1};
    index.classes.push_back(aspect);
    for (const MadeContour& contour : contours) {
      ClassContour written;
      written.types = {size(index.type_scores), size(contour)};
      index.class_contours.push_back(written);
      for (const auto& [type, score] : contour) index.type_scores.push_back({type, score});
    }
  }
  return made;
}

OwnedMatcher::OwnedMatcher(const ClassIndex& index) : index_(index) {
  memory_.plan([&](Arena& arena) { matcher_.prepare(arena, {&index_, 1}); });
}

ClassMatch OwnedMatcher::match(const std::vector<ContourFeature>& features, std::size_t class_id,
                               Matching matching) {
  matcher_.set_contours(index_, features);
  return matcher_.match(index_, class_id, matching);
}

}  // namespace aspect
