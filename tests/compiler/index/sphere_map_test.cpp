#include "compiler/index/sphere_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "tests/compiler/viewsphere/sphere_samples.h"

namespace aspect {
namespace {

constexpr int kDeepest = 12;

// Runs of leaves of one class, as an object has them.
SphereClasses random_classes(std::mt19937& random, const ViewSphere& sphere,
                             std::size_t class_count) {
  SphereClasses classes;
  classes.class_of.assign(sphere.patch_count(), kNoClass);
  std::int32_t current = kNoClass;
  for (const PatchId leaf : sphere.leaves()) {
    if (random() % 4 == 0) current = static_cast<std::int32_t>(random() % (class_count + 1)) - 1;
    classes.class_of[static_cast<std::size_t>(leaf)] = current;
  }
  return classes;
}

// A few smooth regions: which of the sites is nearest to the middle of a leaf.
SphereClasses nearest_site_classes(const ViewSphere& sphere,
                                   const std::vector<Eigen::Vector3d>& sites) {
  SphereClasses classes;
  classes.class_of.assign(sphere.patch_count(), kNoClass);
  for (const PatchId leaf : sphere.leaves()) {
    const auto& c = sphere.patch(leaf).corners;
    const Eigen::Vector3d middle =
        sphere.position(c[0]) + sphere.position(c[1]) + sphere.position(c[2]);
    const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return a.dot(middle) < b.dot(middle);
    };
    classes.class_of[static_cast<std::size_t>(leaf)] = static_cast<std::int32_t>(
        std::max_element(sites.begin(), sites.end(), nearer) - sites.begin());
  }
  return classes;
}

struct LeafClass {
  int level;
  std::int32_t class_id;
  bool operator==(const LeafClass&) const = default;
};

std::vector<LeafClass> leaf_classes(const ViewSphere& sphere, const SphereClasses& classes) {
  std::vector<LeafClass> found;
  for (const PatchId leaf : sphere.leaves())
    found.push_back({sphere.patch(leaf).level, classes.class_of[static_cast<std::size_t>(leaf)]});
  return found;
}

}  // namespace

TEST_CASE("a map that was written and read again has the same leaves and classes") {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const std::size_t class_count = std::array{0U, 1U, 2U, 3U, 255U, 256U, 3000U}[seed % 7];
    const ViewSphere sphere = random_sphere(seed, static_cast<int>(seed) * 5, 8);
    const SphereClasses classes = random_classes(random, sphere, class_count);
    const auto bytes = encode_sphere_map(sphere, classes, class_count, kDeepest);
    const Result<SphereMap> map = decode_sphere_map(bytes, class_count);
    INFO("seed " << seed);
    REQUIRE(map.ok());
    CHECK(leaf_classes(map.value().sphere, map.value().classes) == leaf_classes(sphere, classes));
  }
}

TEST_CASE("a coarser map divides what it merges along the borders") {
  constexpr int kSamples = 5000;
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    const ViewSphere sphere = uniform_sphere(6);
    std::vector<Eigen::Vector3d> sites;
    for (int k = 0; k < 12; ++k) sites.push_back(random_direction(random));
    const SphereClasses classes = nearest_site_classes(sphere, sites);
    for (int level = 3; level <= 6; ++level) {
      const SphereMap map =
          decode_sphere_map(encode_sphere_map(sphere, classes, sites.size(), level), sites.size())
              .value();
      for (const PatchId leaf : map.sphere.leaves()) CHECK(map.sphere.patch(leaf).level <= level);
      int wrong = 0;
      for (int k = 0; k < kSamples; ++k) {
        const Eigen::Vector3d direction = random_direction(random);
        if (map.at(direction) != classes.at(sphere, direction)) ++wrong;
      }
      INFO("seed " << seed << ", level " << level << ": " << wrong);
      // Undivided, the patches on borders would be 10 % of the sphere at level 5 already.
      CHECK(wrong * 100 <= kSamples * (level == 6 ? 0 : level == 3 ? 3 : 2));
    }
  }
}

TEST_CASE("the map within a budget is the finest that fits") {
  std::mt19937 random(7);
  const ViewSphere sphere = uniform_sphere(4);
  std::vector<Eigen::Vector3d> sites;
  for (int k = 0; k < 20; ++k) sites.push_back(random_direction(random));
  const SphereClasses classes = nearest_site_classes(sphere, sites);
  for (int level = 0; level <= 4; ++level) {
    const std::size_t size = encode_sphere_map(sphere, classes, 20, level).size();
    const auto exact = encode_sphere_map_within(sphere, classes, 20, size);
    CHECK(exact == encode_sphere_map(sphere, classes, 20, level));
    if (level == 0) continue;
    const auto tight = encode_sphere_map_within(sphere, classes, 20, size - 1);
    CHECK(tight.size() < size);
    CHECK(tight == encode_sphere_map(sphere, classes, 20, level - 1));
  }
}

TEST_CASE("a map cut short anywhere is refused in one line") {
  std::mt19937 random(8);
  const ViewSphere sphere = random_sphere(8, 100, 6);
  const auto bytes = encode_sphere_map(sphere, random_classes(random, sphere, 9), 9, kDeepest);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const Result<SphereMap> map = decode_sphere_map(std::span(bytes).first(length), 9);
    REQUIRE_FALSE(map.ok());
    CHECK(map.error().find('\n') == std::string::npos);
  }
}

TEST_CASE("garbage for a map is refused or gives classes that exist") {
  std::mt19937 random(9);
  int taken = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::uint8_t> bytes(random() % 300);
    // Few set bits, so that leaves come about, or any.
    for (std::uint8_t& byte : bytes)
      byte = static_cast<std::uint8_t>(round % 2 == 0 ? random() & random() & random() : random());
    const std::size_t class_count = random() % 6;
    const Result<SphereMap> map = decode_sphere_map(bytes, class_count);
    if (!map.ok()) continue;
    ++taken;
    CHECK(map.value().classes.class_of.size() == map.value().sphere.patch_count());
    for (const std::int32_t id : map.value().classes.class_of)
      CHECK((id >= kNoClass && id < static_cast<std::int32_t>(class_count)));
  }
  CHECK(taken > 50);
  const std::vector<std::uint8_t> ones(1U << 20U, 0xFF);
  CHECK_FALSE(decode_sphere_map(ones, 3).ok());
}

}  // namespace aspect
