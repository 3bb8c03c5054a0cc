// Values that are searched for pictures whose areas are known.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tools/calibrate/segmentation/segmentation_search.h"

namespace aspect {
namespace {

// Two painted halves, lit from one side by `shading`, noise over them.
WantedAreas halves(unsigned seed, double shading, double noise) {
  cv::RNG dice(seed);
  cv::Mat picture(96, 128, CV_8UC3, cv::Scalar(0, 0, 0)), paints(96, 128, CV_16S, cv::Scalar(-1));
  const int edge = 40 + static_cast<int>(seed % 7) * 6;
  for (int y = 16; y < 80; ++y)
    for (int x = 16; x < 112; ++x) {
      const bool left = x < edge;
      const cv::Vec3d colour = left ? cv::Vec3d(60, 40, 120) : cv::Vec3d(120, 70, 30);
      const double light = 1 - (y > 44 ? shading : 0);
      for (int c = 0; c < 3; ++c)
        picture.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<std::uint8_t>(colour[c] * light + dice.gaussian(noise));
      paints.at<std::int16_t>(y, x) = left ? 0 : 1;
    }
  return wanted_areas(picture, paints);
}

std::vector<WantedAreas> several(unsigned first, int count, double shading, double noise) {
  std::vector<WantedAreas> frames;
  for (int k = 0; k < count; ++k)
    frames.push_back(halves(first + static_cast<unsigned>(k), shading, noise));
  return frames;
}

TEST_CASE("Regions that are the areas score 1, and half of each about a half") {
  RegionMatch match;
  CHECK(match.score(halves(1, 0, 1), {}) > 0.95);
  VisionParameters nothing;
  nothing.intensity_min = 700;
  CHECK(match.score(halves(1, 0, 1), nothing) == 0);
  VisionParameters parted;  // by a shadow
  parted.intensity_step = 15;
  const double score = match.score(halves(1, 0.4, 1), parted);
  CHECK(score > 0.4);
  CHECK(score < 0.7);
}

TEST_CASE(
    "Where a shadow parts surfaces, values are found with which it does not, on other frames, "
    "too") {
  VisionParameters start;
  start.intensity_step = 20;
  const SearchedValues found = search_values(several(1, 3, 0.4, 1), start);
  CHECK(found.score_before < 0.7);
  CHECK(found.score_after > 0.95);
  CHECK(found.parameters.intensity_step > 20);
  const HeldOut held_out = compare_values(several(20, 4, 0.4, 1), start, found.parameters);
  CHECK(held_out.is_better);
  CHECK(held_out.gain > 0.2);
  const auto changed = changed_values(start, found.parameters);
  REQUIRE_FALSE(changed.empty());
  CHECK(std::any_of(changed.begin(), changed.end(),
                    [](const auto& c) { return c.first == "intensity_step"; }));
}

TEST_CASE("Where the present values do well nothing is proposed, and never on too few frames") {
  const VisionParameters start;
  const SearchedValues found = search_values(several(1, 3, 0, 1), start);
  CHECK_FALSE(compare_values(several(20, 4, 0, 1), start, found.parameters).is_better);
  VisionParameters bad;
  bad.intensity_step = 15;
  CHECK_FALSE(compare_values(several(20, 2, 0.4, 1), bad, start).is_better);
  // What helps one frame and harms another is chance.
  std::vector<WantedAreas> mixed = several(20, 2, 0.4, 1);
  for (WantedAreas& frame : several(30, 2, 0, 1)) mixed.push_back(std::move(frame));
  VisionParameters joins;
  joins.chroma_step = 120;
  CHECK_FALSE(compare_values(mixed, bad, joins).is_better);
}

}  // namespace
}  // namespace aspect
