#include "tools/replay/seen_explanation.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "runtime/base/planned_memory.h"

namespace aspect {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kRed{200, 20, 20}, kGreen{20, 200, 20}, kBlue{20, 20, 200};

// A picture of rectangles on black, as Vision sees it.
class Scenery {
 public:
  void paint(const Box& box, const Rgb& colour) {
    for (int y = box.y; y < box.y + box.height; ++y)
      for (int x = box.x; x < box.x + box.width; ++x)
        for (std::size_t k = 0; k < 3; ++k)
          pixels_[static_cast<std::size_t>(y * kWidth + x) * 3 + k] = colour[k];
  }

  SeenFrame seen(std::span<const ClassIndex> indexes, std::span<const CameraModel> cameras) {
    memory_.plan([&](Arena& arena) { vision_.prepare(arena, kWidth, kHeight); });
    const Frame frame = {pixels_.data(), kWidth, kHeight, std::ptrdiff_t{3} * kWidth,
                         PixelFormat::rgb8};
    const ViewGraph graph = vision_.run(frame, VisionParameters());
    return {graph, &vision_.regions(), &vision_.colours(), indexes, cameras};
  }

 private:
  static constexpr int kWidth = 640, kHeight = 480;
  std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(std::size_t{3} * kWidth * kHeight);
  PlannedMemory memory_;
  Vision vision_;
};

// A flat square of side 2, red above and green below, of the scene's surfaces 7 and 8.
ClassIndex square() {
  PaintedModel painted;
  for (const double y : {-1.0, 0.0, 1.0})
    for (const double x : {-1.0, 1.0}) painted.vertices.push_back({x, y, 0});
  painted.paints = {kRed, kGreen};
  painted.triangles = {{{0, 1, 3}, 0}, {{0, 3, 2}, 0}, {{2, 3, 5}, 1}, {{2, 5, 4}, 1}};
  ClassIndex index;
  index.object = "square";
  index.model = prepared_model(painted, 3, 60);
  index.surfaces = {7, 8};
  index.class_contours.resize(2);
  index.class_contours[0] = {{}, {0, 1}, index.model.shares[0], {0, -0.5F, 0}};
  index.class_contours[1] = {{}, {1, 1}, index.model.shares[1], {0, 0.5F, 0}};
  index.classes.resize(1);
  index.classes[0].contours = {0, 2};
  return index;
}

// The square covers 220 to 419 in x, 140 to 339 in y.
const std::vector<CameraModel> kCameras = {{500, 500, 319.5, 239.5}};
VerifiedPose straight_ahead() {
  VerifiedPose pose;
  pose.refined.pose = {{}, {0, 0, 5}};
  return pose;
}
const Box kUpper{220, 140, 200, 100}, kLower{220, 240, 200, 100};

}  // namespace

TEST_CASE("Nothing is missing and nothing contradicts where a model is seen as drawn") {
  const std::vector<ClassIndex> indexes = {square()};
  Scenery scenery;
  scenery.paint(kUpper, kRed);
  scenery.paint(kLower, kGreen);
  const SeenFrame frame = scenery.seen(indexes, kCameras);
  REQUIRE(frame.graph.contours.size() == 2);
  const std::vector<ContourMatch> matches = {{0, 0}, {1, 1}};
  Hypothesis hypothesis;
  hypothesis.contours = matches;
  const VerifiedPose pose = straight_ahead();
  const SeenExplanation explanation = explain_seen(hypothesis, &pose, {}, frame);
  CHECK(explanation.missing.empty());
  CHECK(explanation.contradicting.empty());
  REQUIRE(explanation.contours.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(explanation.contours[k].contour == k);
    CHECK(explanation.contours[k].name == k);
    REQUIRE(explanation.contours[k].surfaces.size() == 1);
    CHECK(explanation.contours[k].surfaces[0] == 7 + k);
    CHECK(explanation.contours[k].colour[k] == Approx(200.0 / 240).margin(0.01));
  }
}

TEST_CASE("What a pose shows and the picture does not is told, and the other way round") {
  const std::vector<ClassIndex> indexes = {square()};
  Scenery scenery;
  scenery.paint(kUpper, kRed);
  // Blue where half of the green should be, and beside it where nothing should be.
  scenery.paint({220, 240, 100, 100}, kGreen);
  scenery.paint({320, 240, 150, 100}, kBlue);
  const SeenFrame frame = scenery.seen(indexes, kCameras);
  const VerifiedPose pose = straight_ahead();
  const SeenExplanation explanation = explain_seen(Hypothesis(), &pose, {}, frame);
  REQUIRE(explanation.missing.size() == 1);
  const MissingPart& part = explanation.missing[0];
  CHECK(part.name == std::uint16_t{1});
  REQUIRE(part.surfaces.size() == 1);
  CHECK(part.surfaces[0] == 8);
  CHECK(part.colour == indexes[0].model.shares[1]);
  REQUIRE(part.area_px);
  CHECK(*part.area_px == Approx(20000).epsilon(0.05));
  REQUIRE(part.covered);
  CHECK(*part.covered == Approx(0.5).margin(0.05));

  REQUIRE(explanation.contradicting.size() == 2);
  CHECK(explanation.contradicting[0].drawn == indexes[0].model.shares[1]);
  CHECK(explanation.contradicting[0].area_px == Approx(10000).epsilon(0.1));
  CHECK_FALSE(explanation.contradicting[1].drawn);
  CHECK(explanation.contradicting[1].area_px == Approx(5000).epsilon(0.1));
  for (const Contradiction& contradiction : explanation.contradicting) {
    CHECK(contradiction.colour[2] == Approx(200.0 / 240).margin(0.01));
    const Contour& contour = frame.graph.contours[contradiction.contour];
    CHECK(contour.area_px == Approx(15000).epsilon(0.02));
  }
}

TEST_CASE("What is beside a part of a scene does not speak against it, what is before it does") {
  const std::vector<ClassIndex> indexes = {square()};
  Scenery scenery;
  scenery.paint({120, 140, 400, 200}, kBlue);
  scenery.paint(kUpper, kRed);
  scenery.paint({220, 240, 100, 100}, kGreen);
  const SeenFrame frame = scenery.seen(indexes, kCameras);
  REQUIRE(frame.graph.blobs.size() == 1);
  const VerifiedPose pose = straight_ahead();
  const Box part{220, 140, 200, 200};
  const SeenExplanation whole = explain_seen(Hypothesis(), &pose, {}, frame),
                        own = explain_seen(Hypothesis(), &pose, {0, part}, frame);
  REQUIRE(own.contradicting.size() == 1);
  CHECK(own.contradicting[0].drawn == indexes[0].model.shares[1]);
  CHECK(own.contradicting[0].area_px == Approx(10000).epsilon(0.1));
  CHECK(std::any_of(whole.contradicting.begin(), whole.contradicting.end(),
                    [](const Contradiction& other) { return !other.drawn; }));
  CHECK(own.missing.size() == 1);
  CHECK(explain_seen(Hypothesis(), nullptr, {0, part}, frame).contradicting.empty());
}

TEST_CASE("A surface of which nothing is seen is missing altogether") {
  const std::vector<ClassIndex> indexes = {square()};
  Scenery scenery;
  scenery.paint(kUpper, kRed);
  const VerifiedPose pose = straight_ahead();
  const SeenFrame frame = scenery.seen(indexes, kCameras);
  const SeenExplanation explanation = explain_seen(Hypothesis(), &pose, {}, frame);
  REQUIRE(explanation.missing.size() == 1);
  CHECK(explanation.missing[0].name == std::uint16_t{1});
  REQUIRE(explanation.missing[0].covered);
  CHECK(*explanation.missing[0].covered < 0.05F);
  CHECK(explanation.contradicting.empty());
}

TEST_CASE("Without a pose, contours without a match are told") {
  const std::vector<ClassIndex> indexes = {square()};
  Scenery scenery;
  scenery.paint(kUpper, kRed);
  scenery.paint(kLower, kBlue);
  const SeenFrame frame = scenery.seen(indexes, kCameras);
  const std::vector<ContourMatch> matches = {{0, 0}};
  Hypothesis hypothesis;
  hypothesis.contours = matches;
  const SeenExplanation explanation = explain_seen(hypothesis, nullptr, {}, frame);
  REQUIRE(explanation.missing.size() == 1);
  CHECK(explanation.missing[0].name == std::uint16_t{1});
  CHECK_FALSE(explanation.missing[0].covered);
  REQUIRE(explanation.contradicting.size() == 1);
  CHECK(explanation.contradicting[0].contour == 1);
  CHECK_FALSE(explanation.contradicting[0].drawn);
  CHECK(explanation.contradicting[0].area_px == Approx(20000).epsilon(0.02));
}

TEST_CASE("A pose that cannot be drawn is as good as none") {
  const std::vector<ClassIndex> indexes = {square()};
  Scenery scenery;
  scenery.paint(kUpper, kRed);
  VerifiedPose pose;
  pose.refined.pose = {{}, {0, 0, -5}};
  const SeenFrame frame = scenery.seen(indexes, kCameras);
  const SeenExplanation explanation = explain_seen(Hypothesis(), &pose, {}, frame);
  CHECK(explanation.missing.size() == 2);
  CHECK(explanation.contradicting.size() == 1);
}

}  // namespace aspect
