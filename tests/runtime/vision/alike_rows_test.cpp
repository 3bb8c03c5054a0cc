// The vector loops against the same written plainly, pixel by pixel.
#include "runtime/vision/alike_rows.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>
#include <vector>

namespace aspect {
namespace {

constexpr std::size_t kPixels = 300;

// Shares of noise, alike often enough that both answers come up.
struct NoiseShares {
  std::array<std::vector<std::uint8_t>, 6> planes;
  ShareRow shares{};

  explicit NoiseShares(std::mt19937& random) {
    for (auto& plane : planes) {
      const auto range = 4 + random() % 40;
      for (std::size_t i = 0; i < kPixels; ++i)
        plane.push_back(static_cast<std::uint8_t>(random() % 8 == 0 ? random() : random() % range));
    }
    for (std::uint8_t& byte : planes[5]) byte = random() % 4 != 0 ? 255 : 0;
    shares = {planes[0].data(), planes[1].data(), planes[2].data(),
              planes[3].data(), planes[4].data(), planes[5].data()};
  }
};

int difference(const std::uint8_t* plane, std::size_t i, std::size_t k) {
  return std::abs(plane[i] - plane[k]);
}

bool plainly_alike(const ShareRow& s, std::size_t i, std::size_t k, int intensity_step) {
  const int allowed = std::max(s.tolerance[i], s.tolerance[k]);
  return difference(s.red, i, k) <= allowed && difference(s.green, i, k) <= allowed &&
         difference(s.blue, i, k) <= allowed && difference(s.intensity, i, k) <= intensity_step;
}

std::vector<std::uint8_t> random_flags(std::mt19937& random) {
  std::vector<std::uint8_t> flags(kPixels);
  for (std::uint8_t& flag : flags) flag = random() % 3 != 0 ? 255 : 0;
  return flags;
}

}  // namespace

TEST_CASE("pixels that must be alike are, unless one is background") {
  std::mt19937 random(41);
  std::array<int, 2> answers{};
  for (int round = 0; round < 200; ++round) {
    const NoiseShares noise(random);
    const std::size_t a = random() % 20, b = random() % 20, count = random() % (kPixels - 20);
    const auto step = static_cast<std::uint8_t>(round % 2 == 0 ? 255 : random() % 40);
    const std::vector<std::uint8_t> before = random_flags(random);
    std::vector<std::uint8_t> core = before;
    require_alike(noise.shares.from(a), noise.shares.from(b), count, step, core.data());
    for (std::size_t i = 0; i < kPixels; ++i) {
      const bool background =
          i < count && (noise.planes[5][a + i] == 0 || noise.planes[5][b + i] == 0);
      const bool kept = i >= count || background || plainly_alike(noise.shares, a + i, b + i, step);
      REQUIRE(core[i] == (kept ? before[i] : 0));
      ++answers[kept ? 1 : 0];
    }
  }
  REQUIRE(answers[0] > 1000);
  REQUIRE(answers[1] > 1000);
}

TEST_CASE("pixels are linked where they are alike and both core") {
  std::mt19937 random(42);
  std::array<int, 2> answers{};
  for (int round = 0; round < 200; ++round) {
    const NoiseShares noise(random);
    const std::size_t a = random() % 20, b = random() % 20, count = random() % (kPixels - 20);
    const auto step = static_cast<std::uint8_t>(round % 2 == 0 ? 255 : random() % 40);
    const std::vector<std::uint8_t> core_a = random_flags(random), core_b = random_flags(random);
    std::vector<std::uint8_t> link(kPixels, 7);
    link_alike(noise.shares.from(a), noise.shares.from(b), core_a.data(), core_b.data(), count,
               step, link.data());
    for (std::size_t i = 0; i < count; ++i) {
      const bool linked =
          core_a[i] != 0 && core_b[i] != 0 && plainly_alike(noise.shares, a + i, b + i, step);
      REQUIRE(link[i] == (linked ? 255 : 0));
      ++answers[linked ? 1 : 0];
    }
    for (std::size_t i = count; i < kPixels; ++i) REQUIRE(link[i] == 7);
  }
  REQUIRE(answers[0] > 1000);
  REQUIRE(answers[1] > 1000);
}

}  // namespace aspect
