// What light has parted, taken together, against the same picture without light.
#include "runtime/recognition/blob_features.h"

#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "runtime/vision/vision.h"

namespace aspect {
namespace {

constexpr int kWidth_px = 120, kHeight_px = 90;
using Colour = std::array<std::uint8_t, 3>;

struct Painting {
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kWidth_px * kHeight_px * 3);

  void fill(const Box& box, const Colour& colour) {
    for (int y = box.y; y < box.y + box.height; ++y)
      for (int x = box.x; x < box.x + box.width; ++x)
        std::copy(colour.begin(), colour.end(), pixels.begin() + (y * kWidth_px + x) * 3);
  }
};

struct Seen {
  explicit Seen(const Painting& painting) {
    memory.plan([&](Arena& arena) { vision.prepare(arena, kWidth_px, kHeight_px); });
    Frame frame;
    frame.format = PixelFormat::rgb8;
    frame.width_px = kWidth_px;
    frame.height_px = kHeight_px;
    frame.stride_bytes = kWidth_px * 3;
    frame.data = painting.pixels.data();
    graph = vision.run(frame, parameters);
  }
  VisionParameters parameters;
  PlannedMemory memory;
  Vision vision;
  ViewGraph graph;
};

constexpr Colour kBlue{20, 40, 200}, kDarkBlue{10, 20, 100}, kRed{200, 30, 30};

TEST_CASE("faces of one colour that meet in other light are the feature that they are without it") {
  Painting flat, lit;
  flat.fill({20, 20, 60, 40}, kBlue);
  lit.fill({20, 20, 60, 40}, kBlue);
  for (Painting* painting : {&flat, &lit}) painting->fill({80, 20, 15, 40}, kRed);
  lit.fill({50, 20, 30, 25}, kDarkBlue);
  Seen in_light(lit), without(flat);
  BlobFeatures parted, joined, whole, unused;
  features_of(in_light.graph, 0, parted);
  features_of(without.graph, 0, whole);
  REQUIRE(parted.count == 3);
  REQUIRE(whole.count == 2);
  CHECK_FALSE(join_alike(without.graph, without.vision.regions(), 0, without.parameters, unused));
  REQUIRE(join_alike(in_light.graph, in_light.vision.regions(), 0, in_light.parameters, joined));
  REQUIRE(joined.count == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const ContourFeature &a = joined.features[k], &b = whole.features[k];
    CHECK(a.area == Approx(b.area).epsilon(1e-5));
    CHECK(a.position.x == Approx(b.position.x).margin(1e-4));
    CHECK(a.position.y == Approx(b.position.y).margin(1e-4));
    for (std::size_t c = 0; c < 3; ++c) CHECK(a.share[c] == Approx(b.share[c]).margin(0.005));
    for (const auto moment : {&Moments::xx, &Moments::xy, &Moments::yy, &Moments::xxx,
                              &Moments::xxy, &Moments::xyy, &Moments::yyy})
      CHECK(a.moments.*moment == Approx(b.moments.*moment).margin(1e-5));
  }
  const Contour& largest = in_light.graph.contours[joined.contours[0]];
  CHECK(largest.mean_rgb[2] > 150);
}

TEST_CASE("faces of one colour that do not touch stay apart") {
  Painting painting;
  painting.fill({20, 20, 60, 40}, kBlue);
  painting.fill({40, 20, 20, 40}, kRed);
  painting.fill({60, 20, 20, 40}, kDarkBlue);
  Seen seen(painting);
  BlobFeatures as_seen, joined;
  features_of(seen.graph, 0, as_seen);
  CHECK(as_seen.count == 3);
  CHECK_FALSE(join_alike(seen.graph, seen.vision.regions(), 0, seen.parameters, joined));
}

}  // namespace
}  // namespace aspect
