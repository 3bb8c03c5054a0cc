// Range frames against what is known of the bodies that they show.
#include "runtime/vision/range_codes.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "tests/rounds.h"
#include "tests/runtime/vision/pictures.h"
#include "tests/runtime/vision/range_scenes.h"

namespace aspect {
namespace {

constexpr int kSide_px = 320;
constexpr int kLeastArea_px = 40;  // what segmentation keeps

VisionParameters range_parameters() {
  VisionParameters parameters = default_parameters(SensorKind::range);
  parameters.one_blob = true;
  return parameters;
}

// Pieces of the picture that show one surface and that a region must stand for: large, and so thick
// that windows fit into them.
std::vector<cv::Mat> certain_pieces(const cv::Mat& surface) {
  constexpr int kThick_px = 11, kCertainArea_px = 150;
  std::vector<cv::Mat> pieces;
  const cv::Mat labels = equal_components(surface);
  double count = 0;
  cv::minMaxLoc(labels, nullptr, &count);
  for (int label = 1; label <= static_cast<int>(count); ++label) {
    const cv::Mat mask = mask_of(labels, label);
    if (cv::countNonZero(mask) < kCertainArea_px) continue;
    cv::Mat inside;
    cv::erode(mask, inside, cv::Mat::ones(kThick_px, kThick_px, CV_8U));
    if (cv::countNonZero(inside) > 0) pieces.push_back(mask);
  }
  return pieces;
}

struct Agreement {
  int pieces = 0, found = 0;        // of the surfaces that must be seen
  int regions = 0, components = 0;  // of the latter those that are large enough for a region
  double misplaced = 0;             // share of the outline's pixels that are with another surface
};

Agreement compare(const RegionMap& map, const cv::Mat& surface) {
  Agreement agreement;
  const cv::Mat labels = label_picture(map, surface.size());
  agreement.regions = static_cast<int>(map.regions.size());
  const cv::Mat truth = equal_components(surface);
  agreement.misplaced = partition_difference(labels, truth);
  double components = 0;
  cv::minMaxLoc(without_small(truth, kLeastArea_px), nullptr, &components);
  agreement.components = static_cast<int>(components);
  for (const cv::Mat& piece : certain_pieces(surface)) {
    ++agreement.pieces;
    for (int label = 1; label <= agreement.regions; ++label) {
      const cv::Mat mask = mask_of(labels, label);
      const double common = cv::countNonZero(mask & piece), all = cv::countNonZero(mask | piece);
      if (common >= 0.85 * all) ++agreement.found;
    }
  }
  return agreement;
}

void check_views(const Body& body, int views, int noise, double least_found) {
  std::mt19937 random(71);
  OwnedVision vision(kSide_px, kSide_px, SensorKind::range);
  int pieces = 0, found = 0;
  for (int k = 0; k < views; ++k) {
    RangeView view = random_range_view(body, random, kSide_px);
    if (noise > 0) add_depth_noise(view.depth, random, noise);
    vision.run(depth_frame(view.depth), range_parameters());
    const Agreement agreement = compare(vision.regions(), view.surface);
    INFO("view " << k);
    CHECK(agreement.misplaced < 0.03);
    CHECK(agreement.regions <= agreement.components);
    pieces += agreement.pieces;
    found += agreement.found;
  }
  CAPTURE(found, pieces);
  CHECK(pieces > 2 * views);
  CHECK(found >= least_found * pieces);
}

int region_count(const Body& body, const Point3& direction) {
  OwnedVision vision(kSide_px, kSide_px, SensorKind::range);
  const RangeView view = range_view(body, direction, 0.3, kSide_px);
  vision.run(depth_frame(view.depth), range_parameters());
  return static_cast<int>(vision.regions().regions.size());
}

}  // namespace

TEST_CASE("the visible planes of a cube are the regions of its range frame, from anywhere") {
  check_views(cube_body(), rounds(40), 0, 1.0);
}

TEST_CASE("the visible planes of an L are its regions, where one hides part of another too") {
  check_views(l_body(), rounds(40), 0, 0.99);
}

TEST_CASE("noise of two steps of the depth changes no plane") {
  check_views(cube_body(), rounds(20), 2, 1.0);
  check_views(l_body(), rounds(20), 2, 0.98);
}

TEST_CASE("parallel faces one behind the other are two regions, at the edge that hides") {
  OwnedVision vision(kSide_px, kSide_px, SensorKind::range);
  const RangeView view = range_view(step_body(), {0.001, 0.002, 1}, 0.4, kSide_px);
  vision.run(depth_frame(view.depth), range_parameters());
  REQUIRE(vision.regions().regions.size() == 2);
  const Agreement agreement = compare(vision.regions(), view.surface);
  CHECK(agreement.found == 2);
  CHECK(agreement.misplaced < 0.02);
}

TEST_CASE("a round surface is one region, and an edge ends it") {
  CHECK(region_count(ball_body(), {0.3, -0.5, 0.7}) == 1);
  CHECK(region_count(cylinder_body(), {1, 0.4, 0.001}) == 1);
  CHECK(region_count(cylinder_body(), {1, 0.4, 0.8}) == 2);
  CHECK(region_count(cylinder_body(), {0.001, 0.002, -1}) == 1);
}

TEST_CASE("an edge blunter than the normal step is none") {
  OwnedVision vision(kSide_px, kSide_px, SensorKind::range);
  const RangeView view = range_view(cube_body(), {1, 0.8, 0.6}, 0, kSide_px);
  VisionParameters parameters = range_parameters();
  vision.run(depth_frame(view.depth), parameters);
  CHECK(vision.regions().regions.size() == 3);
  parameters.range.normal_step_deg = 90;
  parameters.range.depth_step = 0.5F;
  vision.run(depth_frame(view.depth), parameters);
  CHECK(vision.regions().regions.size() < 3);
}

TEST_CASE("depths outside of the steps looked at are background") {
  OwnedVision vision(kSide_px, kSide_px, SensorKind::range);
  RangeView view = range_view(cube_body(), {1, 0.8, 0.6}, 0, kSide_px);
  VisionParameters parameters = range_parameters();
  vision.run(depth_frame(view.depth), parameters);
  const cv::Mat alone = label_picture(vision.regions(), view.depth.size());
  cv::Mat walled = view.depth.clone();
  walled.setTo(20000, view.depth == 0);
  vision.run(depth_frame(walled), parameters);
  CHECK(vision.regions().regions.size() == 4);
  parameters.range.steps_max = 15000;
  vision.run(depth_frame(walled), parameters);
  CHECK(same_partition(alone, label_picture(vision.regions(), view.depth.size())));
}

TEST_CASE("pixels without a measurement, 0 or 65535, are background and hurt nobody beside them") {
  OwnedVision vision(kSide_px, kSide_px, SensorKind::range);
  RangeView view = range_view(cube_body(), {1, 0.8, 0.6}, 0, kSide_px);
  std::mt19937 random(5);
  for (int k = 0; k < 200; ++k) {
    const int x = static_cast<int>(random() % kSide_px), y = static_cast<int>(random() % kSide_px);
    view.depth.at<std::uint16_t>(y, x) = k % 2 == 0 ? 0 : 65535;
  }
  vision.run(depth_frame(view.depth), range_parameters());
  CHECK(vision.regions().regions.size() == 3);
  const cv::Mat labels = label_picture(vision.regions(), view.depth.size());
  CHECK(cv::countNonZero(labels != 0 & (view.depth == 0 | view.depth == 65535)) == 0);
}

TEST_CASE("frames that show nothing, or are of another sensor, give empty graphs") {
  OwnedVision vision(64, 64, SensorKind::range);
  for (const int depth : {0, 65535}) {
    const cv::Mat nothing(64, 64, CV_16UC1, cv::Scalar(depth));
    CHECK(vision.run(depth_frame(nothing), range_parameters()).contours.empty());
    CHECK(vision.regions().regions.empty());
  }
  const cv::Mat wall(64, 64, CV_16UC1, cv::Scalar(9000));
  CHECK(vision.run(depth_frame(wall), range_parameters()).contours.size() == 1);
  for (const PixelFormat format :
       {PixelFormat::rgb8, PixelFormat::bgr8, PixelFormat::grey8, PixelFormat::label16}) {
    Frame frame = depth_frame(wall);
    frame.format = format;
    frame.width_px = 16;
    CHECK(vision.run(frame, range_parameters()).contours.empty());
  }
  CHECK(vision.run(depth_frame(wall), VisionParameters{}).contours.empty());
  OwnedVision colour_vision(64, 64);
  CHECK(colour_vision.run(depth_frame(wall), VisionParameters{}).contours.empty());
  CHECK(colour_vision.run(depth_frame(wall), range_parameters()).contours.empty());
}

TEST_CASE("frames smaller than a window, and rows at odd bytes, are read as they are") {
  OwnedVision vision(64, 64, SensorKind::range);
  for (int side = 1; side < 8; ++side) {
    const cv::Mat wall(side, side, CV_16UC1, cv::Scalar(9000));
    vision.run(depth_frame(wall), range_parameters());
  }
  std::vector<std::uint8_t> bytes(1 + 131 * 64);
  const std::uint16_t depth = 9000;
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 0; x < 64; ++x)
      std::memcpy(bytes.data() + 1 + 131 * y + 2 * x, &depth, sizeof depth);
  const Frame odd{bytes.data() + 1, 64, 64, 131, PixelFormat::depth16};
  CHECK(vision.run(odd, range_parameters()).contours.size() == 1);
}

}  // namespace aspect
