// Pictures made to run into the capacities of the segmentation: what is left must be consistent,
// counted, and the same for every frame that went before.
#include <catch2/catch.hpp>
#include <map>
#include <opencv2/core.hpp>
#include <random>
#include <set>
#include <vector>

#include "runtime/vision/vision_limits.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

VisionParameters keep_everything() {
  VisionParameters parameters = exact_parameters();
  parameters.area_min_px = 1;
  parameters.thickness_min_px = 0;
  return parameters;
}

// Labels and runs must tell the same, up to the number of regions.
void check_consistent(const RegionMap& map, cv::Size size) {
  const cv::Mat labels = label_picture(map, size);
  cv::Mat from_runs = cv::Mat::zeros(size, CV_32S);
  std::map<int, double> area;
  for (const Run& run : map.runs) {
    from_runs(cv::Range(run.row, run.row + 1), cv::Range(run.begin, run.end)) = run.label;
    area[run.label] += run.end - run.begin;
  }
  REQUIRE(cv::countNonZero(from_runs != labels) == 0);
  for (std::size_t k = 0; k < map.regions.size(); ++k)
    REQUIRE(map.regions[k].sums.area == area[static_cast<int>(k) + 1]);
}

// Stripes one pixel wide, which are core, as each pixel has equal ones left and right of it. Where
// the colours change, every `band` rows, two rows have no core and are filled in later.
cv::Mat striped(cv::Size size, int band) {
  cv::Mat picture(size, CV_8UC3);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const cv::Scalar value = colour(x % 2 + y / band % 2 * 2);
      for (int channel = 0; channel < 3; ++channel)
        picture.at<cv::Vec3b>(y, x)[channel] = cv::saturate_cast<std::uint8_t>(value[channel]);
    }
  return picture;
}

// Stripes all the way down on the right; on the left, other ones from `row` on.
cv::Mat striped_from(cv::Size size, int row) {
  cv::Mat picture = striped(size, size.height);
  const cv::Rect corner(0, row, 20, size.height - row);
  striped(size, 1).row(1).colRange(0, 20).copyTo(picture(corner).row(0));
  cv::repeat(picture(corner).row(0).clone(), corner.height, 1, picture(corner));
  return picture;
}

}  // namespace

TEST_CASE("stripes of one pixel overflow the runs and leave labels that match their runs") {
  for (const cv::Size size : {cv::Size(64, 80), cv::Size(131, 61), cv::Size(12, 300)})
    for (const int band : {3, 4, 5, 7, 9, 1000}) {
      OwnedVision vision(size.width, size.height);
      const ViewGraph graph = vision.run(striped(size, band), keep_everything());
      REQUIRE(graph.dropped_regions > 0);
      REQUIRE_FALSE(vision.regions().regions.empty());
      check_consistent(vision.regions(), size);
    }
}

TEST_CASE("an overflowing frame gives the same regions whatever frame went before") {
  std::mt19937 random(16);
  const cv::Size size(96, 90);
  OwnedVision used(size.width, size.height);
  for (int row = 15; row < 35; ++row) {
    const cv::Mat crowded = striped_from(size, row);
    OwnedVision fresh(size.width, size.height);
    fresh.run(crowded, keep_everything());
    const cv::Mat expected = label_picture(fresh.regions(), size);
    const cv::Mat plain(size, CV_8UC3, colour(2));
    for (const cv::Mat& before : {plain, noise_picture(random, size), striped(size, 5)}) {
      used.run(before, keep_everything());
      used.run(crowded, keep_everything());
      REQUIRE(cv::countNonZero(label_picture(used.regions(), size) != expected) == 0);
    }
  }
}

TEST_CASE("regions below the rows that blobs have room for belong to no blob") {
  // Stripes of foreground that change colour from row to row have no core, but many runs.
  const cv::Size size(120, 100);
  cv::Mat picture = cv::Mat::zeros(size, CV_8UC3);
  for (int y = 0; y < 70; ++y)
    for (int x = 0; x < size.width; x += 2)
      picture.at<cv::Vec3b>(y, x) =
          y / 2 % 2 == 0 ? cv::Vec3b(200, 20, 20) : cv::Vec3b(20, 200, 20);
  const cv::Rect block(30, 75, 40, 20);
  picture(block) = colour(2);
  OwnedVision vision(size.width, size.height);
  const ViewGraph graph = vision.run(picture, keep_everything());
  REQUIRE(graph.dropped_regions > 0);
  const RegionMap& map = vision.regions();
  REQUIRE(map.regions.size() >= 1);
  for (const Region& region : map.regions) {
    if (region.blob >= static_cast<int>(map.blobs.size())) continue;
    const Box& blob = map.blobs[static_cast<std::size_t>(region.blob)].box;
    REQUIRE(region.box.x >= blob.x);
    REQUIRE(region.box.y >= blob.y);
    REQUIRE(region.box.y + region.box.height <= blob.y + blob.height);
  }
}

TEST_CASE("of too many regions the smallest are dropped and counted") {
  constexpr int kSide = 12, kColumns = 40, kRows = 30;
  cv::Mat picture = cv::Mat::zeros(kRows * kSide, kColumns * kSide, CV_8UC3);
  std::mt19937 random(17);
  int small = 0;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const bool big = random() % 4 != 0;
      small += big ? 0 : 1;
      const int side = big ? kSide - 2 : kSide - 5;
      picture(cv::Rect(column * kSide, row * kSide, side, side)) = colour(row * 3 + column);
    }
  const int all = kRows * kColumns;
  REQUIRE(all - small < kMaxRegions);
  REQUIRE(all > kMaxRegions);
  OwnedVision vision(picture.cols, picture.rows);
  VisionParameters parameters = exact_parameters();
  parameters.one_blob = true;
  vision.run(picture, parameters);
  const RegionMap& map = vision.regions();
  REQUIRE(static_cast<int>(map.regions.size()) == kMaxRegions);
  REQUIRE(map.dropped_regions == all - kMaxRegions);
  int big = 0;
  for (const Region& region : map.regions) big += region.sums.area > 50 ? 1 : 0;
  REQUIRE(big == all - small);
  check_consistent(map, picture.size());
}

TEST_CASE("of too many blobs the smallest are dropped and counted") {
  constexpr int kSide = 20, kColumns = 12, kRows = 10;
  cv::Mat picture = cv::Mat::zeros(kRows * kSide, kColumns * kSide, CV_8UC3);
  for (int i = 0; i < kRows * kColumns; ++i) {
    const int side = 7 + i * 7 % 11;
    picture(cv::Rect(i % kColumns * kSide, i / kColumns * kSide, side, side)) = colour(i);
  }
  OwnedVision vision(picture.cols, picture.rows);
  VisionParameters parameters = exact_parameters();
  const ViewGraph graph = vision.run(picture, parameters);
  REQUIRE(static_cast<int>(graph.blobs.size()) == kMaxBlobs);
  REQUIRE(graph.dropped_regions == kRows * kColumns - kMaxBlobs);
  const double smallest_kept = graph.blobs.back().area_px;
  int larger = 0;
  for (int i = 0; i < kRows * kColumns; ++i) {
    const int side = 7 + i * 7 % 11;
    larger += side * side > smallest_kept ? 1 : 0;
  }
  REQUIRE(larger < kMaxBlobs);
  REQUIRE(static_cast<int>(graph.contours.size()) == kMaxBlobs);
}

}  // namespace aspect
