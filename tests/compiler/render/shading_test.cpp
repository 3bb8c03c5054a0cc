#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/compiler/render/reference_tracer.h"
#include "tests/compiler/render/test_scenes.h"

using namespace aspect;
using Eigen::Vector3d;

namespace {

constexpr int kSize = 96;

Vector3d point_at(const Scene& scene, const Camera& camera, int x, int y) {
  const Intrinsics& in = camera.intrinsics;
  const ReferenceHit hit = reference_hit(scene, camera, x, y);
  const Vector3d ray((x - in.cx_px) / in.fx_px, (y - in.cy_px) / in.fy_px, 1);
  return camera.position_object + hit.depth * (camera.camera_from_object.transpose() * ray);
}

int worst_channel_error(const Picture& picture, std::size_t pixel, const Vector3d& color) {
  int worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double truth = 255 * std::clamp(color[static_cast<Eigen::Index>(k)], 0.0, 1.0);
    worst = std::max(worst, std::abs(static_cast<int>(picture.rgb[3 * pixel + k]) -
                                     static_cast<int>(std::lround(truth))));
  }
  return worst;
}

// Every pixel of the only primitive against the formula, with the normal given by a function; the
// light is taken to reach it wherever it stands on the camera's side.
template <typename Normal>
void require_lit(const Scene& scene, const Camera& camera, Normal normal_at) {
  Picture picture;
  renderer_of(scene).render(camera, picture);
  int lit = 0, dark = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const auto k = static_cast<std::size_t>(y * kSize + x);
      if (picture.surface[k] == 0 || reference_hit(scene, camera, x, y).surface == 0) continue;
      const Vector3d point = point_at(scene, camera, x, y);
      Vector3d normal = normal_at(point);
      if (normal.dot(camera.position_object - point) < 0) normal = -normal;
      const Surface& surface = scene.surfaces[0];
      Vector3d color = scene.studio.ambient.cwiseProduct(surface.ambient);
      bool reached = false;
      for (const Light& light : scene.lights) {
        const double cosine = normal.dot((light.position - point).normalized());
        if (cosine > 0) color += cosine * surface.diffuse.cwiseProduct(light.color);
        reached = reached || cosine > 0;
      }
      ++(reached ? lit : dark);
      INFO("x " << x << " y " << y);
      REQUIRE(worst_channel_error(picture, k, color) <= 1);
    }
  CHECK(lit > 100);
  CHECK(dark > 100);
}

Scene one_surface() {
  Scene scene = empty_scene(kSize, kSize);
  scene.studio.ambient = {0.2, 0.3, 0.1};
  scene.surfaces = {{{0.9, 0.5, 0.3}, {1, 0.5, 0.2}}};
  return scene;
}

}  // namespace

TEST_CASE("a lit sphere follows the formula, with shadows and without") {
  for (const bool shadows : {false, true}) {
    Scene scene = one_surface();
    scene.primitives = {{Sphere{{0, 0, 0}, 0.3}, 0}};
    scene.lights = {{{0, 1, 2}, {0.5, 0.6, 0.7}, shadows}, {{0.3, 2, 1}, {0.3, 0.1, 0}, shadows}};
    require_lit(scene, camera_at(scene.studio, Vector3d(1, 0.2, 0).normalized()),
                [](const Vector3d& point) { return Vector3d(point.normalized()); });
  }
}

TEST_CASE("a lit cone follows the formula on its outside") {
  Scene scene = one_surface();
  scene.primitives = {{Cone{{0, -0.3, 0}, {0, 0.3, 0}, 0.25, 0}, 0}};
  scene.lights = {{{0.5, 0.4, 2}, {0.8, 0.8, 0.8}, true}};
  require_lit(scene, camera_at(scene.studio, {1, 0, 0}), [](const Vector3d& point) {
    return Vector3d(Vector3d(point.x(), 0, point.z()).normalized() + Vector3d(0, 0.25 / 0.6, 0))
        .normalized();
  });
}

TEST_CASE("a plate is lit on the side that the camera sees") {
  Scene scene = one_surface();
  scene.primitives = {
      {Polygon{{{-0.3, -0.3, 0}, {0.3, -0.3, 0}, {0.3, 0.3, 0}, {-0.3, 0.3, 0}}}, 0}};
  scene.lights = {{{0.2, 0.3, 1}, {1, 1, 1}, true}};
  const Renderer renderer = renderer_of(scene);
  Picture front, back;
  renderer.render(camera_at(scene.studio, {0, 0, 1}), front);
  renderer.render(camera_at(scene.studio, {0, 0, -1}), back);
  const std::size_t middle = kSize / 2 * kSize + kSize / 2;
  const Vector3d ambient(0.2, 0.15, 0.02);
  CHECK(worst_channel_error(back, middle, ambient) == 0);
  const double cosine = 1 / std::sqrt(0.04 + 0.09 + 1);
  CHECK(worst_channel_error(front, middle, ambient + cosine * Vector3d(0.9, 0.5, 0.3)) <= 1);
}

TEST_CASE("a lit mesh looks like its triangles as polygons") {
  Scene mesh = mesh_sphere_scene(kSize, 2), polygons = faceted_sphere_scene(kSize, 2);
  mesh.surfaces = {{{0.9, 0.5, 0.3}, {0.2, 0.2, 0.2}}};
  for (Surface& surface : polygons.surfaces) surface = mesh.surfaces[0];
  mesh.lights = polygons.lights = {{{2, 1, 0.3}, {1, 1, 1}, true}};
  Picture one, other;
  renderer_of(mesh).render(camera_at(mesh.studio, {0.6, 0, 0.8}), one);
  renderer_of(polygons).render(camera_at(mesh.studio, {0.6, 0, 0.8}), other);
  CHECK(one.rgb == other.rgb);
}

TEST_CASE("a disc casts its shadow on the floor, and only where the light casts shadows") {
  Scene scene = one_surface();
  scene.studio.up = {0, 1, 0};
  scene.studio.ambient = {0.2, 0.2, 0.2};
  scene.surfaces = {{{0.5, 0.5, 0.5}, {1, 1, 1}}};
  scene.primitives = {
      {Polygon{{{-0.4, -0.4, 0}, {0.4, -0.4, 0}, {0.4, 0.4, 0}, {-0.4, 0.4, 0}}}, 0},
      {Ring{{0.3, 0, 0.5}, {0, 0, 1}, 0, 0.1}, 0}};
  const Vector3d light(0.6, 0, 1);  // so the shadow is a disc of radius 0.2 about (0, 0, 0)
  for (const bool shadows : {false, true}) {
    scene.lights = {{light, {1, 1, 1}, shadows}};
    const Camera camera = camera_at(scene.studio, Vector3d(-1, 0, 1).normalized());
    Picture picture;
    renderer_of(scene).render(camera, picture);
    int shaded = 0, lit = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const auto k = static_cast<std::size_t>(y * kSize + x);
        if (picture.surface[k] != 1 || reference_hit(scene, camera, x, y).surface != 1) continue;
        const Vector3d point = point_at(scene, camera, x, y);
        if (std::abs(point.norm() - 0.2) < 1e-3) continue;
        const bool in_shadow = shadows && point.norm() < 0.2;
        ++(in_shadow ? shaded : lit);
        const double cosine = (light - point).normalized().z();
        const double level = 0.2 + (in_shadow ? 0 : 0.5 * cosine);
        INFO("x " << x << " y " << y);
        REQUIRE(worst_channel_error(picture, k, Vector3d::Constant(level)) <= 1);
      }
    CHECK(lit > 500);
    CHECK((shaded > 300) == shadows);
  }
}
