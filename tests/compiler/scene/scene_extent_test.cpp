// Box and diameter against points sampled densely on the surfaces.
#include "compiler/scene/scene_extent.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace aspect {
namespace {

struct Random {
  std::mt19937 engine{11};
  double from(double least, double most) {
    return least + (most - least) * static_cast<double>(engine()) / 4294967295.0;
  }
  Eigen::Vector3d point() { return {from(-1, 1), from(-1, 1), from(-1, 1)}; }
};

constexpr int kSteps = 400;

void add_circle(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius,
                std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d u = radius * normal.unitOrthogonal(), v = normal.cross(u);
  for (int k = 0; k < kSteps; ++k) {
    const double angle = 2 * std::numbers::pi * k / kSteps;
    points.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
  }
}

// Points of a surface that its outermost are near to.
std::vector<Eigen::Vector3d> sampled(const Scene& scene) {
  std::vector<Eigen::Vector3d> points;
  for (const Primitive& primitive : scene.primitives) {
    if (const auto* polygon = std::get_if<Polygon>(&primitive.shape))
      points.insert(points.end(), polygon->vertices.begin(), polygon->vertices.end());
    if (const auto* ring = std::get_if<Ring>(&primitive.shape))
      add_circle(ring->center, ring->normal, ring->max_radius, points);
    if (const auto* cone = std::get_if<Cone>(&primitive.shape)) {
      const Eigen::Vector3d axis = (cone->apex - cone->base).normalized();
      add_circle(cone->base, axis, cone->base_radius, points);
      add_circle(cone->apex, axis, cone->apex_radius, points);
    }
    if (const auto* sphere = std::get_if<Sphere>(&primitive.shape))
      for (int k = 1; k < 40; ++k) {
        const double angle = std::numbers::pi * k / 40;
        add_circle(sphere->center + Eigen::Vector3d(0, 0, sphere->radius * std::cos(angle)),
                   Eigen::Vector3d::UnitZ(), sphere->radius * std::sin(angle), points);
      }
  }
  return points;
}

double largest_distance(const std::vector<Eigen::Vector3d>& points) {
  double largest = 0;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      largest = std::max(largest, (points[a] - points[b]).squaredNorm());
  return std::sqrt(largest);
}

void check_against_samples(const Scene& scene, double tolerance) {
  const SceneExtent extent = scene_extent(scene);
  const std::vector<Eigen::Vector3d> points = sampled(scene);
  Eigen::Vector3d least = points.front(), most = points.front();
  for (const Eigen::Vector3d& point : points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  CHECK((extent.least.array() <= least.array() + 1e-9).all());
  CHECK((extent.most.array() >= most.array() - 1e-9).all());
  CHECK((extent.least - least).norm() < tolerance);
  CHECK((extent.most - most).norm() < tolerance);
  const double distance = largest_distance(points);
  CHECK(extent.diameter >= distance - 1e-9);
  CHECK(extent.diameter <= distance + tolerance);
}

}  // namespace

TEST_CASE("a box has its diagonal, a ball its diameter, a cylinder its slanted length") {
  Scene scene;
  CHECK(scene_extent(scene).diameter == 0);
  scene.primitives.push_back({Sphere{{1, 2, 3}, .5}, 0});
  CHECK(scene_extent(scene).diameter == 1);
  CHECK(scene_extent(scene).least == Eigen::Vector3d(.5, 1.5, 2.5));
  CHECK(scene_extent(scene).most == Eigen::Vector3d(1.5, 2.5, 3.5));
  scene.primitives = {{Cone{{0, 0, -2}, {0, 0, 2}, 1.5, 1.5}, 0}};
  CHECK(scene_extent(scene).diameter == Approx(5).epsilon(1e-12));
  CHECK(scene_extent(scene).most.isApprox(Eigen::Vector3d(1.5, 1.5, 2)));
  scene.primitives = {{Polygon{{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}}, 0},
                      {Polygon{{{0, 0, 2}, {1, 0, 2}, {1, 2, 2}, {0, 2, 2}}}, 0}};
  CHECK(scene_extent(scene).diameter == 3);
}

TEST_CASE("random scenes reach as far as points sampled on them") {
  Random random;
  for (int round = 0; round < 12; ++round) {
    Scene scene;
    for (int k = 0; k < 2; ++k) {
      scene.primitives.push_back({Polygon{{random.point(), random.point(), random.point()}}, 0});
      scene.primitives.push_back(
          {Ring{random.point(), random.point().normalized(), 0, random.from(.1, 1)}, 0});
      scene.primitives.push_back(
          {Cone{random.point(), random.point(), random.from(0, 1), random.from(0, 1)}, 0});
    }
    check_against_samples(scene, 1e-3);
  }
  Scene balls;
  balls.primitives = {{Sphere{{.3, .1, 0}, .4}, 0}, {Ring{{-.5, 0, .2}, {0, 0, 1}, 0, .3}, 0}};
  check_against_samples(balls, 0.01);
}

}  // namespace aspect
