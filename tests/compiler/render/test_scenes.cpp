#include "tests/compiler/render/test_scenes.h"

#include <array>
#include <catch2/catch.hpp>

namespace aspect {

using Eigen::Vector3d;

Scene empty_scene(int width_px, int height_px) {
  Scene scene;
  scene.name = "test";
  scene.studio.angle_deg = 50;
  scene.studio.up = {0, 1, 0.05};
  scene.studio.width_px = width_px;
  scene.studio.height_px = height_px;
  scene.studio.aspect = double{1} * width_px / height_px;
  scene.studio.ambient = {1, 1, 1};
  return scene;
}

void add_shape(Scene& scene, const decltype(Primitive::shape)& shape) {
  const auto number = static_cast<int>(scene.primitives.size());
  const Vector3d color(0.1 + 0.13 * (number % 7), 0.9 - 0.2 * (number % 5), 0.2 * (number % 4));
  scene.surfaces.push_back({color, color});
  scene.primitives.push_back({shape, static_cast<int>(scene.surfaces.size()) - 1});
}

void add_box(Scene& scene, const Vector3d& least, const Vector3d& greatest) {
  for (int axis = 0; axis < 3; ++axis)
    for (const Vector3d& side : {least, greatest}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Polygon face;
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        Vector3d corner;
        corner[axis] = side[axis];
        corner[u] = a == 0 ? least[u] : greatest[u];
        corner[v] = b == 0 ? least[v] : greatest[v];
        face.vertices.push_back(corner);
      }
      add_shape(scene, face);
    }
}

Scene box_scene(int size_px) {
  Scene scene = empty_scene(size_px, size_px);
  add_box(scene, {-0.21, -0.19, -0.17}, {0.2, 0.18, 0.22});
  return scene;
}

Scene closed_cylinder_scene(int size_px) {
  Scene scene = empty_scene(size_px, size_px);
  const Vector3d axis = Vector3d(1, 2, 3).normalized();
  const Vector3d base = -0.2 * axis, apex = 0.25 * axis;
  add_shape(scene, Cone{base, apex, 0.2, 0.13});
  add_shape(scene, Ring{base, -axis, 0, 0.2});
  add_shape(scene, Ring{apex, axis, 0, 0.13});
  return scene;
}

Scene faceted_sphere_scene(int size_px, int splits) {
  using Facet = std::array<Vector3d, 3>;
  std::vector<Facet> facets;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        facets.push_back({Vector3d(x, 0, 0), Vector3d(0, y, 0), Vector3d(0, 0, z)});
  for (int k = 0; k < splits; ++k) {
    std::vector<Facet> finer;
    for (const auto& [a, b, c] : facets) {
      const Vector3d ab = (a + b).normalized(), bc = (b + c).normalized(),
                     ca = (c + a).normalized();
      for (const Facet& facet : {Facet{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(facet);
    }
    facets = std::move(finer);
  }
  Scene scene = empty_scene(size_px, size_px);
  for (const auto& [a, b, c] : facets) add_shape(scene, Polygon{{0.33 * a, 0.33 * b, 0.33 * c}});
  return scene;
}

Renderer renderer_of(const Scene& scene) {
  Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) FAIL(renderer.error());
  return std::move(renderer).value();
}

double Random::uniform(double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(engine_);
}

int Random::whole(int least, int most) {
  return std::uniform_int_distribution<int>(least, most)(engine_);
}

Vector3d Random::direction() {
  std::normal_distribution<double> normal;
  Vector3d result;
  for (double& coordinate : result) coordinate = normal(engine_);
  return result.normalized();
}

Vector3d Random::point(double reach) {
  Vector3d result;
  for (double& coordinate : result) coordinate = uniform(-reach, reach);
  return result;
}

}  // namespace aspect
