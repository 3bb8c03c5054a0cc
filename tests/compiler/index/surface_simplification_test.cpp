#include "compiler/index/surface_simplification.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

namespace aspect {
namespace {

constexpr int kBands = 100, kSides = 100;

// A ball of radius 1 whose upper half has another colour.
ColouredSurface two_coloured_ball() {
  ColouredSurface ball;
  std::map<std::pair<int, int>, std::uint32_t> known;
  const auto point = [&](int band, int side) {
    const bool pole = band == 0 || band == kBands;
    const std::pair key(band, pole ? 0 : side % kSides);
    const auto [found, is_new] =
        known.try_emplace(key, static_cast<std::uint32_t>(ball.points.size()));
    if (is_new) {
      const double up = std::numbers::pi * band / kBands,
                   round = 2 * std::numbers::pi * key.second / kSides;
      ball.points.emplace_back(std::sin(up) * std::cos(round), std::sin(up) * std::sin(round),
                               -std::cos(up));
    }
    return found->second;
  };
  for (int band = 0; band < kBands; ++band)
    for (int side = 0; side < kSides; ++side) {
      const std::uint16_t paint = band < kBands / 2 ? 0 : 1;
      const std::uint32_t a = point(band, side), b = point(band, side + 1),
                          c = point(band + 1, side + 1), d = point(band + 1, side);
      if (a != b) ball.triangles.push_back({{a, b, c}, paint});
      if (c != d) ball.triangles.push_back({{a, c, d}, paint});
    }
  return ball;
}

}  // namespace

TEST_CASE("A ball of two colours becomes some hundred triangles that hardly stray from it") {
  const ColouredSurface ball = two_coloured_ball();
  REQUIRE(ball.triangles.size() == 2 * kSides * (kBands - 1));
  const SimplifiedSurface simple = simplified_surface(ball, 800, 0.003);
  CHECK(simple.surface.triangles.size() <= 800);
  CHECK(simple.surface.triangles.size() > 50);
  CHECK(simple.error > 0);
  CHECK(simple.error < 0.03);
  for (const ColouredTriangle& t : simple.surface.triangles) {
    // Corners of a colour stay on its half, so that the border is where it was.
    for (const std::uint32_t corner : t.corners) {
      const double height = simple.surface.points[corner].z();
      if (t.paint == 0) CHECK(height <= 1e-6);
      if (t.paint == 1) CHECK(height >= -1e-6);
    }
  }
}

TEST_CASE("A surface of few triangles stays as it is") {
  ColouredSurface square;
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 1}};
  const SimplifiedSurface simple = simplified_surface(square, 800, 0.01);
  CHECK(simple.surface.triangles.size() == 2);
  CHECK(simple.error == Approx(0).margin(1e-12));
}

}  // namespace aspect
