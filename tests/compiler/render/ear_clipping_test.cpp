#include "compiler/scene/ear_clipping.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/compiler/render/test_scenes.h"

using namespace aspect;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

using Outline = std::vector<Vector2d>;

double doubled_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double area_of(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < outline.size(); ++k)
    sum += doubled_area(outline[0], outline[k], outline[k + 1]) / 2;
  return std::abs(sum);
}

bool contains(const Outline& outline, const Vector2d& p) {
  bool inside = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2d& a = outline[k];
    const Vector2d& b = outline[(k + 1) % outline.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

// Placed anywhere in space; the triangles come back in the plane.
std::vector<Triangle> triangulate_in_space(const Outline& outline, Random& random) {
  const Vector3d normal = random.direction(), origin = random.point(1);
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vector3d> vertices;
  for (const Vector2d& p : outline) vertices.push_back(origin + p.x() * u + p.y() * v);
  return triangulate(vertices);
}

// Areas that add up, and random points each in as many triangles as the outline says: 0 or 1.
void require_covered_once(const Outline& outline, Random& random) {
  const std::vector<Triangle> triangles = triangulate_in_space(outline, random);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const double area = std::abs(doubled_area(outline[a], outline[b], outline[c])) / 2;
    REQUIRE(area > 0);
    sum += area;
  }
  REQUIRE(sum == Approx(area_of(outline)).epsilon(1e-9));

  for (const auto& [a, b, c] : triangles)
    for (int k = 0; k < 5; ++k) {
      double s = random.uniform(0.01, 0.98), t = random.uniform(0.01, 0.98);
      if (s + t > 0.99) s = 0.99 - 0.5 * s, t = 0.005;
      const Vector2d p = outline[a] + s * (outline[b] - outline[a]) + t * (outline[c] - outline[a]);
      REQUIRE(contains(outline, p));
    }
}

// Simple for any radii: every vertex at its own angle.
Outline random_star(Random& random) {
  const int count = random.whole(3, 60);
  Outline outline;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * (k + random.uniform(0, 0.9)) / count;
    const double radius = random.uniform(0.05, 1);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

bool cross_each_other(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  return doubled_area(a, b, c) * doubled_area(a, b, d) < 0 &&
         doubled_area(c, d, a) * doubled_area(c, d, b) < 0;
}

// Random points joined in random order, crossings undone one by one: winding caves and corridors.
Outline random_tangle(Random& random) {
  Outline outline;
  const int count = random.whole(4, 40);
  for (int k = 0; k < count; ++k)
    outline.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
  for (bool crossed = true; crossed;) {
    crossed = false;
    for (std::size_t i = 0; i + 2 < outline.size(); ++i)
      for (std::size_t j = i + 2; j < outline.size(); ++j)
        if (cross_each_other(outline[i], outline[i + 1], outline[j],
                             outline[(j + 1) % outline.size()])) {
          std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       outline.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          crossed = true;
        }
  }
  return outline;
}

}  // namespace

TEST_CASE("triangles cover random star-shaped polygons exactly") {
  Random random(2);
  for (int k = 0; k < 300; ++k) require_covered_once(random_star(random), random);
}

TEST_CASE("triangles cover random winding polygons exactly") {
  Random random(3);
  for (int k = 0; k < 300; ++k) require_covered_once(random_tangle(random), random);
}

TEST_CASE("triangles cover combs and spirals, wound either way") {
  Random random(4);
  Outline comb = {{0, 0}, {10, 0}};
  for (int k = 10; k > 0; --k) {
    comb.emplace_back(k - 0.5, 1);
    comb.emplace_back(k - 0.5, 0.1);
    comb.emplace_back(k - 1, 0.1);
  }
  Outline spiral, back;
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.3 * k;
    const Vector2d direction(std::cos(angle), std::sin(angle));
    spiral.push_back((1 + 0.1 * angle) * direction);
    back.push_back((1.3 + 0.1 * angle) * direction);
  }
  spiral.insert(spiral.end(), back.rbegin(), back.rend());
  for (Outline* outline : {&comb, &spiral}) {
    require_covered_once(*outline, random);
    std::reverse(outline->begin(), outline->end());
    require_covered_once(*outline, random);
  }
}

TEST_CASE("repeated and straight vertices change nothing") {
  Random random(5);
  require_covered_once({{0, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}},
                       random);
  require_covered_once({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}}, random);
}

TEST_CASE("a vertex in the middle of a straight edge is a corner of a triangle") {
  const std::vector<Vector3d> vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  std::vector<bool> used(vertices.size(), false);
  for (const Triangle& triangle : triangulate(vertices))
    for (const std::uint32_t corner : triangle) used[corner] = true;
  for (const bool corner : used) CHECK(corner);
}

TEST_CASE("holes joined to the border by a double edge stay open") {
  Random random(6);
  const Outline frame = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                         {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  require_covered_once(frame, random);
  const Outline two = {{0, 0}, {9, 0}, {9, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3},
                       {5, 1}, {5, 3}, {7, 3}, {7, 1}, {5, 1}, {3, 3}, {3, 1}, {1, 1}};
  require_covered_once(two, random);
}

TEST_CASE("polygons without area have no triangles, and broken ones come to an end") {
  CHECK(triangulate(std::vector<Vector3d>{{0, 0, 0}, {1, 1, 1}}).empty());
  CHECK(triangulate(std::vector<Vector3d>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}).empty());
  CHECK(triangulate(std::vector<Vector3d>(9, Vector3d(1, 2, 3))).empty());
  Random random(7);
  for (int k = 0; k < 200; ++k) {
    std::vector<Vector3d> vertices;
    for (int n = random.whole(3, 30); n > 0; --n)
      vertices.emplace_back(random.whole(0, 3), random.whole(0, 3), 0);
    CHECK(triangulate(vertices).size() <= vertices.size() - 2);
  }
}

TEST_CASE("convex is what has no inward corner and winds once") {
  const auto regular = [](int count, int winds) {
    std::vector<Vector3d> vertices;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * winds * k / count;
      vertices.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    }
    return vertices;
  };
  for (int count = 3; count < 20; ++count) {
    std::vector<Vector3d> polygon = regular(count, 1);
    CHECK(is_convex(polygon));
    std::reverse(polygon.begin(), polygon.end());
    CHECK(is_convex(polygon));
  }
  CHECK_FALSE(is_convex(regular(5, 2)));
  CHECK_FALSE(is_convex(regular(7, 3)));
  std::vector<Vector3d> dented = regular(9, 1);
  dented[4] *= 0.5;
  CHECK_FALSE(is_convex(dented));
}
