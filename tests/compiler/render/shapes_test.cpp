// Every kind of surface against double-precision brute force: ids and depths of whole pictures.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/compiler/render/picture_check.h"
#include "tests/compiler/render/test_scenes.h"

using namespace aspect;
using Eigen::Vector3d;

namespace {

constexpr int kSize = 160;

void require_right_from_random_directions(const Scene& scene, std::uint32_t seed, int views) {
  Random random(seed);
  const Renderer renderer = renderer_of(scene);
  for (int k = 0; k < views; ++k)
    require_like_reference(scene, renderer,
                           camera_at(scene.studio, random.direction(), random.uniform(0.7, 1.5)));
}

Polygon gear(int teeth, const Vector3d& center, const Vector3d& normal) {
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Polygon polygon;
  for (int k = 0; k < 4 * teeth; ++k) {
    const double angle = 2 * std::numbers::pi * k / (4 * teeth);
    const double radius = k % 4 < 2 ? 0.3 : 0.15;
    polygon.vertices.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return polygon;
}

// Triangles with one corner in common, in different planes.
Mesh fan(int triangles, const Vector3d& center, Random& random) {
  Mesh mesh;
  mesh.vertices = {center, center + random.point(0.1)};
  for (int k = 0; k < triangles; ++k) {
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    mesh.vertices.push_back(center + random.point(0.15));
    mesh.triangles.push_back({0, last, last + 1});
  }
  return mesh;
}

void add_random_shape(Scene& scene, Random& random) {
  const Vector3d center = random.point(0.2), axis = random.direction();
  switch (random.whole(0, 5)) {
    case 0:
      return add_shape(scene, Sphere{center, random.uniform(0.02, 0.15)});
    case 1:
      return add_shape(scene, Ring{center, axis, random.whole(0, 1) * random.uniform(0.02, 0.08),
                                   random.uniform(0.1, 0.2)});
    case 2:
      return add_shape(scene, Cone{center, center + random.uniform(0.05, 0.3) * axis,
                                   random.uniform(0, 0.1), random.uniform(0.02, 0.1)});
    case 3:
      return add_shape(scene, gear(random.whole(2, 6), center, axis));
    case 4:
      return add_shape(scene, fan(random.whole(1, 6), center, random));
    default:
      const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
      const double a = random.uniform(0.05, 0.3), b = random.uniform(0.05, 0.3);
      return add_shape(scene,
                       Polygon{{center, center + a * u, center + a * u + b * v, center + b * v}});
  }
}

}  // namespace

TEST_CASE("a sphere's silhouette and depth are right at every pixel of a 512x512 picture") {
  Scene scene = empty_scene(512, 512);
  add_shape(scene, Sphere{{0.05, -0.03, 0.02}, 0.3});
  const Camera camera = camera_at(scene.studio, Vector3d(1, 2, -0.5).normalized());
  require_like_reference(scene, renderer_of(scene), camera);
}

TEST_CASE("small spheres are right from random directions") {
  Scene scene = empty_scene(kSize, kSize);
  add_shape(scene, Sphere{{0.1, 0.1, 0}, 0.01});
  add_shape(scene, Sphere{{0, -0.1, 0.2}, 0.05});
  add_shape(scene, Sphere{{0, 0, 0}, 0.11});
  require_right_from_random_directions(scene, 11, 8);
}

TEST_CASE("a ring and a disc are right from random directions") {
  Scene scene = empty_scene(kSize, kSize);
  add_shape(scene, Ring{{0.05, 0, 0}, Vector3d(1, 1, 0).normalized(), 0.1, 0.25});
  add_shape(scene, Ring{{-0.1, 0.1, 0.1}, Vector3d(0, 1, -2).normalized(), 0, 0.2});
  require_right_from_random_directions(scene, 12, 12);
}

TEST_CASE("an open cylinder is right from random directions") {
  Scene scene = empty_scene(kSize, kSize);
  add_shape(scene, Cone{{-0.1, -0.2, 0}, {0.1, 0.2, 0.1}, 0.15, 0.15});
  require_right_from_random_directions(scene, 13, 12);
}

TEST_CASE("a pointed cone and a truncated one are right from random directions") {
  Scene scene = empty_scene(kSize, kSize);
  add_shape(scene, Cone{{-0.1, -0.2, 0}, {0, 0.2, 0}, 0.1, 0});
  add_shape(scene, Cone{{0.1, 0, 0.2}, {0.1, 0.05, -0.2}, 0.02, 0.15});
  require_right_from_random_directions(scene, 14, 12);
}

TEST_CASE("thin rods are right from random directions") {
  Scene scene = empty_scene(kSize, kSize);
  add_shape(scene, Cone{{-0.3, 0, 0}, {0.3, 0.05, 0}, 0.01, 0.01});
  add_shape(scene, Cone{{0, -0.3, 0}, {0, 0.3, 0.1}, 0.012, 0.005});
  require_right_from_random_directions(scene, 15, 8);
}

TEST_CASE("concave polygons are right from random directions") {
  Scene scene = empty_scene(kSize, kSize);
  add_shape(scene, gear(7, {0, 0, 0}, {0, 0, 1}));
  add_shape(scene, gear(5, {0, 0.05, 0.02}, Vector3d(1, 1, 3).normalized()));
  require_right_from_random_directions(scene, 16, 12);
}

TEST_CASE("a box is right from random directions, along its axes, and from inside") {
  const Scene scene = box_scene(kSize);
  require_right_from_random_directions(scene, 17, 12);
  const Renderer renderer = renderer_of(scene);
  for (const Vector3d& direction : {Vector3d(1, 0, 0), {0, 0, -1}, {0, 1, 0}})
    require_like_reference(scene, renderer, camera_at(scene.studio, direction));
  require_like_reference(scene, renderer, camera_at(scene.studio, {0.6, 0.8, 0}, 0.01));
}

TEST_CASE("a mesh is right from random directions and from inside") {
  const Scene scene = mesh_sphere_scene(kSize, 2);
  require_right_from_random_directions(scene, 19, 4);
  require_like_reference(scene, renderer_of(scene), camera_at(scene.studio, {0.6, 0.8, 0}, 0.01));
}

TEST_CASE("random heaps of all shapes are right, also from among them") {
  Random random(18);
  for (int heap = 0; heap < 25; ++heap) {
    Scene scene = empty_scene(random.whole(60, 100), random.whole(60, 100));
    for (int k = random.whole(1, 12); k > 0; --k) add_random_shape(scene, random);
    const Renderer renderer = renderer_of(scene);
    for (int view = 0; view < 4; ++view) {
      const Camera camera = camera_at(scene.studio, random.direction(), random.uniform(0.15, 1.2));
      Picture picture;
      renderer.render(camera, picture);
      const PictureComparison found = compare_with_reference(scene, camera, picture);
      INFO("heap " << heap << " view " << view << " " << found.first_wrong);
      REQUIRE(found.wrong_id == 0);
      REQUIRE(found.worst_depth < 1e-4);
    }
  }
}
