// Adjacency against plain geometry: two leaves are neighbours where arcs of both lie on the same
// great circle and overlap in more than a point. Nothing of the sphere's own links is used.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "compiler/viewsphere/viewsphere.h"
#include "tests/compiler/viewsphere/sphere_samples.h"

namespace aspect {
namespace {

// Edges of level 10 are about 1e-3 long and bend by more than 1e-4 where they do not go straight
// on, rounding is about 1e-16.
constexpr double kSame = 1e-10;

// One edge of a leaf, with a coordinate along it that is 0 at its start, in radians.
struct Arc {
  PatchId leaf{};
  std::size_t edge = 0;
  Eigen::Vector3d start;
  Eigen::Vector3d end;
  Eigen::Vector3d normal;
  Eigen::Vector3d forward;
  double length = 0;

  double along(const Eigen::Vector3d& point) const {
    return std::atan2(point.dot(forward), point.dot(start));
  }
};

struct Overlap {
  PatchId leaf{};
  std::size_t edge = 0;
  double begin = 0;
  double end = 0;
};

std::array<Arc, 3> arcs_of(const ViewSphere& sphere, PatchId leaf) {
  std::array<Arc, 3> arcs;
  for (std::size_t k = 0; k < 3; ++k) {
    Arc& arc = arcs[k];
    arc.leaf = leaf;
    arc.edge = k;
    arc.start = sphere.position(sphere.patch(leaf).corners[k]);
    arc.end = sphere.position(sphere.patch(leaf).corners[(k + 1) % 3]);
    arc.normal = arc.start.cross(arc.end).normalized();
    arc.forward = arc.normal.cross(arc.start);
    arc.length = arc.along(arc.end);
  }
  return arcs;
}

// The icosahedron's great circles come round again at the antipodes; those are no candidates.
bool on_same_circle(const Arc& a, const Arc& b) {
  const bool same_side = (a.start + a.end).dot(b.start + b.end) > 0;
  return same_side && std::abs(a.normal.dot(b.start)) < kSame &&
         std::abs(a.normal.dot(b.end)) < kSame;
}

// Pieces of the leaf's edges by the leaf on the other side, in the order of going round.
std::vector<Overlap> plain_neighbours(const std::array<Arc, 3>& ours, const std::vector<Arc>& all) {
  std::vector<Overlap> found;
  for (const Arc& mine : ours) {
    for (const Arc& other : all) {
      if (other.leaf == mine.leaf || !on_same_circle(mine, other)) continue;
      const double begin = std::max(0.0, std::min(mine.along(other.start), mine.along(other.end)));
      const double end =
          std::min(mine.length, std::max(mine.along(other.start), mine.along(other.end)));
      if (end - begin > kSame) found.push_back({other.leaf, mine.edge, begin, end});
    }
  }
  std::sort(found.begin(), found.end(), [](const Overlap& a, const Overlap& b) {
    return std::pair(a.edge, a.begin) < std::pair(b.edge, b.begin);
  });
  return found;
}

void check_against_geometry(const ViewSphere& sphere) {
  std::vector<Arc> all;
  for (const PatchId leaf : sphere.leaves()) {
    for (const Arc& arc : arcs_of(sphere, leaf)) all.push_back(arc);
  }
  for (const PatchId leaf : sphere.leaves()) {
    std::vector<PatchId> expected;
    for (const Overlap& piece : plain_neighbours(arcs_of(sphere, leaf), all)) {
      expected.push_back(piece.leaf);
    }
    REQUIRE(sphere.neighbours(leaf) == expected);
  }
}

TEST_CASE("neighbours are those that share a piece of an edge, in the order of going round") {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    check_against_geometry(random_sphere(seed, 40 * static_cast<int>(seed), 6));
  }
}

TEST_CASE("a leaf may border leaves many levels finer and coarser") {
  ViewSphere sphere;
  const PatchId coarse{0};
  const PatchId beside = sphere.neighbours(coarse)[1];
  const auto& corners = sphere.patch(coarse).corners;
  // On the border, then a little to the other side of it.
  Eigen::Vector3d spot = 2 * sphere.position(corners[1]) + sphere.position(corners[2]);
  for (const VertexId corner : sphere.patch(beside).corners) spot += 1e-5 * sphere.position(corner);
  for (int level = 0; level < 10; ++level) sphere.split(sphere.locate(spot));

  int widest = 0;
  for (const PatchId other : sphere.neighbours(coarse)) {
    widest = std::max(widest, sphere.patch(other).level);
  }
  CHECK(widest == 10);
  CHECK(sphere.neighbours(sphere.locate(spot)).size() == 3);
  check_against_geometry(sphere);
}

TEST_CASE("adjacency is symmetric, irreflexive and names nobody twice") {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const ViewSphere sphere = random_sphere(seed, 3000, 12);
    for (const PatchId leaf : sphere.leaves()) {
      std::vector<PatchId> around = sphere.neighbours(leaf);
      for (const PatchId other : around) {
        REQUIRE(other != leaf);
        REQUIRE_FALSE(sphere.patch(other).split);
        const std::vector<PatchId> back = sphere.neighbours(other);
        REQUIRE(std::count(back.begin(), back.end(), leaf) == 1);
      }
      std::sort(around.begin(), around.end());
      REQUIRE(std::adjacent_find(around.begin(), around.end()) == around.end());
    }
  }
}

TEST_CASE("every leaf of a uniform sphere has three neighbours, one an edge in order") {
  for (int level = 0; level <= 5; ++level) {
    const ViewSphere sphere = uniform_sphere(level);
    for (const PatchId leaf : sphere.leaves()) {
      const std::vector<PatchId> around = sphere.neighbours(leaf);
      REQUIRE(around.size() == 3);
      const auto& corners = sphere.patch(leaf).corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& others = sphere.patch(around[k]).corners;
        CHECK(std::count(others.begin(), others.end(), corners[k]) == 1);
        CHECK(std::count(others.begin(), others.end(), corners[(k + 1) % 3]) == 1);
      }
    }
  }
}

// Equation 3.2: the leaves along an edge, weighed by 2^-level, fill it.
TEST_CASE("neighbours along an edge fill it by their levels") {
  const ViewSphere sphere = random_sphere(30, 3000, 12);
  for (const PatchId leaf : sphere.leaves()) {
    double edges = 0;
    for (const PatchId other : sphere.neighbours(leaf)) {
      const int finer = std::max(0, sphere.patch(other).level - sphere.patch(leaf).level);
      edges += std::ldexp(1, -finer);
    }
    REQUIRE(edges == 3);
  }
}

}  // namespace
}  // namespace aspect
