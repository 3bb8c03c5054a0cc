// The capacities of a graph, and the bytes of the arena that Vision asks for.
#include "runtime/vision/vision_limits.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

// One connected piece of squares of many sizes that touch along a common ground.
cv::Mat crowded_blob(std::mt19937& random, int count, std::vector<int>& areas) {
  constexpr int kPitch = 24, kColumns = 12;
  const int rows = (count + kColumns - 1) / kColumns;
  cv::Mat picture = cv::Mat::zeros(rows * kPitch, kColumns * kPitch, CV_8UC3);
  for (int i = 0; i < count; ++i) {
    const int width = 8 + static_cast<int>(random() % 13),
              height = 8 + static_cast<int>(random() % 13);
    areas.push_back(width * height);
    picture(cv::Rect(i % kColumns * kPitch, i / kColumns * kPitch, width, height)) =
        colour(i / kColumns % 2 * 4 + i % 4);
  }
  return picture;
}

VisionParameters one_blob() {
  VisionParameters parameters = exact_parameters();
  parameters.one_blob = true;
  return parameters;
}

}  // namespace

TEST_CASE("of too many contours of a blob the largest are kept, in the order found") {
  std::mt19937 random(37);
  for (const int count : {kMaxBlobContours, kMaxBlobContours + 1, 120}) {
    std::vector<int> areas;
    const cv::Mat picture = crowded_blob(random, count, areas);
    OwnedVision vision(picture.cols, picture.rows);
    const ViewGraph graph = vision.run(picture, one_blob());
    REQUIRE(graph.blobs.size() == 1);
    REQUIRE(graph.contours.size() == static_cast<std::size_t>(kMaxBlobContours));
    REQUIRE(graph.blobs[0].contour_count == kMaxBlobContours);
    REQUIRE(graph.dropped_regions == count - kMaxBlobContours);
    REQUIRE(static_cast<int>(graph.relations.size()) == kMaxBlobContours * (kMaxBlobContours - 1));
    std::sort(areas.rbegin(), areas.rend());
    areas.resize(static_cast<std::size_t>(kMaxBlobContours));
    std::vector<int> kept;
    for (const Contour& contour : graph.contours) kept.push_back(static_cast<int>(contour.area_px));
    std::sort(kept.rbegin(), kept.rend());
    REQUIRE(kept == areas);
    REQUIRE(std::is_sorted(graph.contours.begin(), graph.contours.end(),
                           [](const Contour& a, const Contour& b) { return a.region < b.region; }));
  }
}

TEST_CASE("a crowded blob takes nothing from the next one") {
  std::mt19937 random(38);
  std::vector<int> areas;
  const cv::Mat crowd = crowded_blob(random, 96, areas);
  cv::Mat picture = cv::Mat::zeros(crowd.rows + 60, crowd.cols, CV_8UC3);
  // A ground makes the squares one blob; it is a contour itself, with its holes.
  picture(cv::Rect(0, 0, crowd.cols, crowd.rows)) = cv::Scalar(60, 60, 60);
  crowd.copyTo(picture(cv::Rect(0, 0, crowd.cols, crowd.rows)), crowd);
  picture(cv::Rect(100, crowd.rows + 20, 50, 30)) = colour(5);
  VisionParameters parameters = exact_parameters();
  OwnedVision vision(picture.cols, picture.rows);
  const ViewGraph graph = vision.run(picture, parameters);
  REQUIRE(graph.blobs.size() == 2);
  REQUIRE(graph.blobs[0].contour_count == kMaxBlobContours);
  REQUIRE(graph.dropped_regions > 0);
  REQUIRE(graph.blobs[1].contour_count == 1);
  REQUIRE(graph.contours.back().box == Box{100, crowd.rows + 20, 50, 30});
}

TEST_CASE("a counting arena and the real one agree on the bytes of Vision") {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(37, 3), cv::Size(512, 512)}) {
    const std::size_t bytes = vision_bytes(size.width, size.height);
    OwnedArena memory(bytes);
    Arena arena = memory.arena();
    Vision vision;
    vision.prepare(arena, size.width, size.height);
    REQUIRE(arena.used_bytes() == bytes);
    REQUIRE(vision.max_width_px() == size.width);
    REQUIRE(vision.max_height_px() == size.height);
  }
}

TEST_CASE("the bytes of Vision's arena change only when that is meant") {
  // Boards are chosen by these: whoever changes one says so in the commit message.
  for (const SensorKind sensor :
       {SensorKind::colour, SensorKind::grey, SensorKind::range, SensorKind::surface})
    std::printf("arena of a %s Vision at 640 x 480: %.2f bytes a pixel\n", name_of(sensor).data(),
                static_cast<double>(vision_bytes(640, 480, sensor)) / (640 * 480));
  // With pointers of 32 bits a little less.
  REQUIRE(vision_bytes(512, 512) == (sizeof(void*) == 8 ? 2889600 : 2856832));
  REQUIRE(vision_bytes(640, 480) == (sizeof(void*) == 8 ? 3295808 : 3263040));
}

TEST_CASE("frames are limited to the longest side that coordinates hold") {
  Arena counting;
  Vision vision;
  vision.prepare(counting, 20000, 16);
  REQUIRE(vision.max_width_px() == kMaxFrameSide_px);
  REQUIRE(vision.max_height_px() == 16);
}

}  // namespace aspect
