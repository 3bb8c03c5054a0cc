// Bounds on what a class costs against the fits of all its key views.
#include "runtime/recognition/class_bounds.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "tests/rounds.h"
#include "tests/runtime/recognition/made_index.h"

namespace aspect {
namespace {

constexpr float kNoLimit = std::numeric_limits<float>::infinity();

std::uint32_t up_to(std::uint32_t most, std::mt19937& random) {
  return static_cast<std::uint32_t>(random() % (most + 1));
}

void add_view(ClassIndex& index, const std::vector<ContourFeature>& contours,
              std::mt19937& random) {
  KeyView view;
  view.contours.first = static_cast<std::uint32_t>(index.key_contours.size());
  for (std::size_t name = 0; name < contours.size(); ++name) {
    if (contours.size() > 1 && random() % 5 == 0) continue;  // not seen from everywhere
    ContourFeature feature = contours[name];
    constexpr float kStep = 0.01F;
    feature.area += kStep * static_cast<float>(up_to(3, random));
    feature.position.x += kStep * static_cast<float>(up_to(5, random));
    index.key_contours.push_back({feature, static_cast<std::uint16_t>(name)});
    ++view.contours.count;
  }
  index.key_views.push_back(view);
}

ClassIndex random_index(std::mt19937& random) {
  ClassIndex index;
  for (std::uint32_t c = up_to(4, random); c > 0; --c) {
    AspectClass& aspect = index.classes.emplace_back();
    std::vector<ContourFeature> contours;
    for (std::uint32_t k = up_to(4, random); k > 0; --k) contours.push_back(random_feature(random));
    aspect.contours = {static_cast<std::uint32_t>(index.class_contours.size()),
                       static_cast<std::uint32_t>(contours.size())};
    for (const ContourFeature& contour : contours)
      index.class_contours.push_back({{}, {}, contour.share, {}});
    aspect.key_views.first = static_cast<std::uint32_t>(index.key_views.size());
    for (std::uint32_t v = up_to(4, random); v > 0; --v) add_view(index, contours, random);
    aspect.key_views.count =
        static_cast<std::uint32_t>(index.key_views.size()) - aspect.key_views.first;
  }
  return index;
}

std::vector<ContourFeature> anything(const ClassIndex& index, std::mt19937& random) {
  std::vector<ContourFeature> seen;
  if (!index.key_views.empty() && random() % 2 == 0) {
    const KeyView& view = index.key_views[random() % index.key_views.size()];
    for (const KeyContour& contour : ClassIndex::part(index.key_contours, view.contours))
      seen.push_back(contour.feature);
  }
  for (std::uint32_t k = up_to(3, random); k > 0; --k) seen.push_back(random_feature(random));
  return seen;
}

}  // namespace

TEST_CASE("no key view costs less than its class's bound, and no class less than its index's") {
  std::mt19937 random(3);
  int tight = 0;
  for (int round = 0; round < rounds(300); ++round) {
    const std::vector<ClassIndex> indexes{random_index(random), random_index(random)};
    ClassBounds bounds;
    PlannedMemory memory;
    memory.plan([&](Arena& arena) { bounds.prepare(arena, indexes); });
    const std::vector<ContourFeature> seen = anything(indexes[random() % 2], random);
    bounds.set_contours(seen);
    ViewFitter fitter;
    fitter.set_contours(seen);
    for (std::size_t i = 0; i < indexes.size(); ++i)
      for (std::size_t c = 0; c < indexes[i].classes.size(); ++c) {
        const float bound = bounds.least_cost(i, c);
        CHECK(bounds.least_cost(i) <= bound * 1.001F);
        float least = kNoLimit;
        for (const KeyView& view :
             ClassIndex::part(indexes[i].key_views, indexes[i].classes[c].key_views))
          least = std::min(
              least,
              fitter.fit(ClassIndex::part(indexes[i].key_contours, view.contours), kNoLimit).cost);
        CHECK(bound <= least + 1e-3F);
        tight += least < kNoLimit && bound > 0.5F * least ? 1 : 0;
      }
  }
  // Bounds that say nothing would hold as well.
  CHECK(tight > rounds(300) / 2);
}

TEST_CASE("matching nothing costs what every contour alone costs") {
  std::mt19937 random(4);
  ClassBounds bounds;
  PlannedMemory memory;
  const std::vector<ClassIndex> none;
  memory.plan([&](Arena& arena) { bounds.prepare(arena, none); });
  const std::vector<ContourFeature> seen{random_feature(random), random_feature(random)};
  bounds.set_contours(seen);
  const ViewFitScales scales;
  CHECK(bounds.most_cost() ==
        Approx(2 * scales.missing + scales.missing_area * (seen[0].area + seen[1].area)));
}

}  // namespace aspect
