#include "compiler/index/sphere_map_writer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "runtime/recognition/sphere_map.h"
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

std::int32_t class_in(const SphereMap& map, const Eigen::Vector3d& direction) {
  return map.class_at({direction.x(), direction.y(), direction.z()});
}

bool same_leaf(const ViewSphere& sphere, PatchId leaf, const SphereMap::Corners& corners) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& corner = sphere.position(sphere.patch(leaf).corners[k]);
    if (corners[k] != Vector3d{corner.x(), corner.y(), corner.z()}) return false;
  }
  return true;
}

// Some of the leaves cut as borders cut them.
void divide_some(std::mt19937& random, const ViewSphere& sphere, SphereClasses& classes,
                 std::size_t class_count) {
  for (const PatchId leaf : sphere.leaves()) {
    if (random() % 5 != 0) continue;
    PatchDivision along_edges;
    const auto steps = [&](unsigned least, unsigned most) {
      return static_cast<double>(least + random() % (most - least)) / 16;
    };
    for (double place = steps(0, 16); place < 3; place += steps(8, 40)) {
      along_edges.places.push_back(place);
      along_edges.classes.push_back(static_cast<std::int32_t>(random() % (class_count + 1)) - 1);
    }
    const PatchDivision division = joined(along_edges);
    if (division.places.size() >= 2 && division.places.size() <= 5)
      classes.divisions[static_cast<std::uint32_t>(leaf)] = division;
  }
}

}  // namespace

TEST_CASE("a map that was written and read again has the same leaves and classes") {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    const std::size_t class_count = std::array{0U, 1U, 2U, 3U, 255U, 256U, 3000U}[seed % 7];
    const ViewSphere sphere = random_sphere(seed, static_cast<int>(seed) * 5, 8);
    const SphereClasses classes = random_classes(random, sphere, class_count);
    const auto bytes = encode_sphere_map(sphere, classes, class_count, kDeepest);
    const Result<SphereMap> map = SphereMap::decode(bytes, class_count);
    INFO("seed " << seed);
    REQUIRE(map.ok());
    const std::vector<SphereMap::Leaf> leaves = map.value().leaves();
    const std::vector<PatchId> expected = sphere.leaves();
    REQUIRE(leaves.size() == expected.size());
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      CHECK(same_leaf(sphere, expected[k], leaves[k].corners));
      CHECK(leaves[k].class_id == classes.class_of[number(expected[k])]);
      CHECK(leaves[k].division == nullptr);
    }
  }
}

// The plain way: the sphere that the map was encoded from, and the divisions as they were written.
TEST_CASE(
    "the device sees the class that the compiler put there, on the borders of patches as well") {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    std::mt19937 random(seed);
    const std::size_t class_count = 2 + seed * 5;
    const ViewSphere sphere = random_sphere(seed, 20 + static_cast<int>(seed) * 10, 9);
    SphereClasses classes = random_classes(random, sphere, class_count);
    divide_some(random, sphere, classes, class_count);
    const SphereMap map =
        SphereMap::decode(encode_sphere_map(sphere, classes, class_count, kDeepest), class_count)
            .value();
    const std::vector<SphereMap::Leaf> leaves = map.leaves();
    const std::vector<PatchId> ids = sphere.leaves();
    int divided = 0;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const SphereMap::Division* division = leaves[k].division;
      if (division == nullptr) continue;
      PatchDivision written;
      for (std::size_t piece = 0; piece < division->count; ++piece) {
        written.places.push_back(division->places[piece] / 16.0);
        written.classes.push_back(division->classes[piece]);
      }
      classes.divisions[static_cast<std::uint32_t>(ids[k])] = written;
      ++divided;
    }
    CHECK(divided > 0);
    const auto expect_same = [&](const Eigen::Vector3d& direction) {
      INFO("seed " << seed << ", " << direction.transpose());
      CHECK(class_in(map, direction) == classes.at(sphere, direction));
    };
    for (int k = 0; k < 2000; ++k) expect_same(random_direction(random));
    // On the edges of patches both round alike; where pieces of one meet, not always.
    for (const PatchId leaf : ids) {
      const auto& c = sphere.patch(leaf).corners;
      for (const Eigen::Vector3d& direction :
           {Eigen::Vector3d(sphere.position(c[0]) + sphere.position(c[1])), sphere.position(c[2])})
        if (classes.divisions.count(static_cast<std::uint32_t>(sphere.locate(direction))) == 0)
          expect_same(direction);
    }
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
          SphereMap::decode(encode_sphere_map(sphere, classes, sites.size(), level), sites.size())
              .value();
      CHECK(map.leaves().size() <= uniform_sphere(level).leaves().size());
      int wrong = 0;
      for (int k = 0; k < kSamples; ++k) {
        const Eigen::Vector3d direction = random_direction(random);
        if (class_in(map, direction) != classes.at(sphere, direction)) ++wrong;
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
    const Result<SphereMap> map = SphereMap::decode(std::span(bytes).first(length), 9);
    REQUIRE_FALSE(map.ok());
    CHECK(map.error().find('\n') == std::string::npos);
  }
}

}  // namespace aspect
