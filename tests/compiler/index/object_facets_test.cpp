#include "compiler/index/object_facets.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "compiler/scene/scene_extent.h"

namespace aspect {
namespace {

Eigen::Vector3d place(const PackedModel& model, std::uint16_t k) {
  const auto& v = model.vertices[k];
  return model.least + model.unit.cwiseProduct(Eigen::Vector3d(v.x(), v.y(), v.z()));
}

Scene scene_of(const decltype(Primitive::shape)& shape) {
  Scene scene;
  Surface red;
  red.diffuse = {1, 0, 0};
  scene.surfaces.push_back(red);
  scene.primitives.push_back({shape, 0});
  return scene;
}

// The largest of `distance` over points strewn on the facets.
template <typename Distance>
double farthest(const PackedModel& model, const Distance& distance) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> share(0, 1);
  double most = 0;
  for (const auto& t : model.triangles)
    for (int k = 0; k < 30; ++k) {
      double u = share(random), v = share(random);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const Eigen::Vector3d a = place(model, t.a()), b = place(model, t.b()),
                            c = place(model, t.c());
      most = std::max(most, distance(a + u * (b - a) + v * (c - a)));
    }
  return most;
}

}  // namespace

TEST_CASE("A cylinder's facets stray from it by no more than the model says") {
  const Scene scene = scene_of(Cone{{0, 0, -2}, {0, 0, 3}, 1.5, 1.5});
  const PackedModel model = packed_model(scene);
  REQUIRE_FALSE(model.triangles.empty());
  CHECK(model.error <= kModelError * scene_extent(scene).diameter);
  CHECK(farthest(model, [](const Eigen::Vector3d& p) {
          return std::abs(p.head<2>().norm() - 1.5);
        }) <= model.error);
}

TEST_CASE("A sphere's facets stray from it by no more than the model says") {
  const Scene scene = scene_of(Sphere{{1, 2, 3}, 0.7});
  const PackedModel model = packed_model(scene);
  REQUIRE_FALSE(model.triangles.empty());
  CHECK(model.error <= kModelError * scene_extent(scene).diameter);
  CHECK(farthest(model, [](const Eigen::Vector3d& p) {
          return std::abs((p - Eigen::Vector3d(1, 2, 3)).norm() - 0.7);
        }) <= model.error);
}

TEST_CASE("A polygon keeps its corners and its colour") {
  const std::vector<Eigen::Vector3d> corners{{0, 0, 1}, {2, 0, 1}, {2, 3, 1}, {1, 1, 1}, {0, 3, 1}};
  const PackedModel model = packed_model(scene_of(Polygon{corners}));
  CHECK(model.triangles.size() == 3);
  CHECK(model.vertices.size() == 5);
  REQUIRE(model.paints.size() == 1);
  CHECK(model.paints[0].red() == 255);
  CHECK(model.paints[0].green() == 0);
  for (const Eigen::Vector3d& corner : corners) {
    double nearest = 1e9;
    for (std::uint16_t k = 0; k < model.vertices.size(); ++k)
      nearest = std::min(nearest, (place(model, k) - corner).norm());
    CHECK(nearest <= model.error);
  }
}

TEST_CASE("A scene without surfaces has an empty model") {
  CHECK(packed_model({}).triangles.empty());
}

}  // namespace aspect
