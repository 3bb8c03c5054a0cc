// Parts of regions of shapes whose areas, middles and moments are known.
#include "runtime/recognition/region_parts.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "runtime/vision/vision.h"

namespace aspect {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr int kWidth_px = 200, kHeight_px = 160;
constexpr Rgb kGreen{30, 140, 40}, kDarkGreen{21, 98, 28}, kRed{150, 30, 30};

// A frame in the colour that `paint` gives each pixel, its regions, and their parts.
class SeenParts {
 public:
  explicit SeenParts(const std::function<Rgb(int, int)>& paint) {
    for (int y = 0; y < kHeight_px; ++y)
      for (int x = 0; x < kWidth_px; ++x) {
        const Rgb rgb = paint(x, y);
        pixels_.insert(pixels_.end(), rgb.begin(), rgb.end());
      }
    memory_.plan([&](Arena& arena) { vision_.prepare(arena, kWidth_px, kHeight_px); });
    const ViewGraph graph = vision_.run(
        {pixels_.data(), kWidth_px, kHeight_px, std::ptrdiff_t{3} * kWidth_px, PixelFormat::rgb8},
        {});
    parts_.find(vision_.regions(), vision_.colours(), graph.contours);
  }

  std::span<const RegionPart> all() const { return parts_.all(); }
  std::size_t regions() const { return vision_.regions().regions.size(); }

  // Those that are no region, about so large.
  std::vector<RegionPart> pieces_of(double area_px) const {
    std::vector<RegionPart> pieces;
    for (const RegionPart& part : all())
      if (!part.is_region && std::abs(static_cast<double>(part.area_px) - area_px) < 0.04 * area_px)
        pieces.push_back(part);
    return pieces;
  }

 private:
  std::vector<std::uint8_t> pixels_;
  PlannedMemory memory_;
  Vision vision_;
  RegionParts parts_;
};

bool within(int x, int y, const Box& box) {
  return x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height;
}

bool has_middle(const std::vector<RegionPart>& parts, float x, float y) {
  return std::any_of(parts.begin(), parts.end(), [&](const RegionPart& part) {
    return std::abs(part.centre_px.x - x) < 2 && std::abs(part.centre_px.y - y) < 2;
  });
}

}  // namespace

TEST_CASE("two squares of one colour that overlap at a corner are told apart") {
  constexpr Box kFirst{20, 15, 60, 60}, kSecond{72, 67, 60, 60};
  const SeenParts seen(
      [&](int x, int y) { return within(x, y, kFirst) || within(x, y, kSecond) ? kGreen : Rgb{}; });
  REQUIRE(seen.regions() == 1);
  // The overlap, 8 x 8, is halved.
  const std::vector<RegionPart> pieces = seen.pieces_of(3600 - 32);
  CHECK(has_middle(pieces, 49.5F, 44.5F));
  CHECK(has_middle(pieces, 101.5F, 96.5F));
  for (const RegionPart& part : pieces) {
    CHECK(part.moments.xx == Approx(1.0 / 12).margin(0.003));
    CHECK(part.moments.yy == Approx(1.0 / 12).margin(0.003));
    CHECK(part.moments.xy == Approx(0).margin(0.003));
    for (const float third :
         {part.moments.xxx, part.moments.xxy, part.moments.xyy, part.moments.yyy})
      CHECK(third == Approx(0).margin(0.002));
    CHECK(part.mean_rgb[1] == Approx(140).margin(3));
    CHECK(part.label == 1);
  }
}

TEST_CASE("a disc on a bar's end is cut off, whichever way the bar points") {
  for (const bool is_upright : {false, true}) {
    const SeenParts seen([&](int x, int y) {
      const int along = is_upright ? y : x, across = is_upright ? x : y;
      const int du = along - 45, dv = across - 80;
      const bool is_disc = du * du + dv * dv < 30 * 30;
      return is_disc || (std::abs(dv) <= 7 && along >= 45 && along < 140) ? kRed : Rgb{};
    });
    REQUIRE(seen.regions() == 1);
    const std::vector<RegionPart> discs = seen.pieces_of(2827);
    REQUIRE_FALSE(discs.empty());
    CHECK(has_middle(discs, is_upright ? 80.0F : 45.0F, is_upright ? 45.0F : 80.0F));
  }
}

TEST_CASE("what has no concave corners is one part, as its region is") {
  const SeenParts seen([&](int x, int y) {
    const int dx = x - 140, dy = y - 80;
    if (dx * dx + dy * dy < 45 * 45) return kRed;
    return within(x, y, {10, 20, 60, 90}) ? kGreen : Rgb{};
  });
  REQUIRE(seen.regions() == 2);
  REQUIRE(seen.all().size() == 2);
  for (const RegionPart& part : seen.all()) {
    CHECK(part.is_region);
    const bool is_disc = part.mean_rgb[0] > 100;
    CHECK(part.area_px == Approx(is_disc ? 6362 : 5400).epsilon(0.01));
    CHECK(part.centre_px.x == Approx(is_disc ? 140 : 39.5).margin(0.5));
    CHECK(part.centre_px.y == Approx(is_disc ? 80 : 64.5).margin(0.5));
  }
}

TEST_CASE("neighbours that only light parts are joined, others are not") {
  for (const bool is_one_colour : {true, false}) {
    const SeenParts seen([&](int x, int y) {
      if (!within(x, y, {30, 30, 120, 80})) return Rgb{};
      if (x < 80) return kGreen;
      return is_one_colour ? kDarkGreen : kRed;
    });
    REQUIRE(seen.regions() == 2);
    const std::vector<RegionPart> joined = seen.pieces_of(9600);
    REQUIRE(joined.size() == (is_one_colour ? 1U : 0U));
    if (!is_one_colour) continue;
    CHECK(has_middle(joined, 89.5F, 69.5F));
    CHECK(joined[0].moments.xx == Approx(1.5 / 12).margin(0.004));
    CHECK(joined[0].moments.yy == Approx(1 / 1.5 / 12).margin(0.004));
  }
}

TEST_CASE("there are never more parts than there is room for, and regions come first") {
  // A comb of many teeth between many squares.
  const SeenParts seen([&](int x, int y) {
    if (y >= 140 || (y >= 100 && x % 12 < 9)) return kRed;
    return x % 11 < 9 && y % 11 < 9 && y < 98 ? ((x / 11 + y / 11) % 2 != 0 ? kGreen : kRed)
                                              : Rgb{};
  });
  REQUIRE(seen.all().size() <= RegionParts::kMost);
  bool are_regions = true;
  for (const RegionPart& part : seen.all()) {
    CHECK((are_regions || !part.is_region));
    are_regions = part.is_region;
  }
}

}  // namespace aspect
