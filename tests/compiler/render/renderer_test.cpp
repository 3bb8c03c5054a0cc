#include "compiler/render/renderer.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <thread>

#include "tests/compiler/render/picture_check.h"
#include "tests/compiler/render/test_scenes.h"

using namespace aspect;
using Eigen::Vector3d;

namespace {

Scene mixed_scene(int width_px, int height_px) {
  Scene scene = empty_scene(width_px, height_px);
  add_box(scene, {-0.2, -0.1, -0.1}, {0.2, 0.1, 0.1});
  add_shape(scene, Cone{{0, 0.1, 0}, {0, 0.3, 0}, 0.07, 0.05});
  add_shape(scene, Ring{{0, 0.3, 0}, {0, 1, 0}, 0, 0.05});
  add_shape(scene, Sphere{{0.2, 0, 0.1}, 0.08});
  return scene;
}

void fill_with_garbage(Picture& picture) {
  std::fill(picture.rgb.begin(), picture.rgb.end(), std::uint8_t{77});
  std::fill(picture.surface.begin(), picture.surface.end(), std::uint16_t{9999});
  std::fill(picture.depth.begin(), picture.depth.end(), -1.0f);
  picture.foreground = {1, 2, 3, 4};
}

void require_refused(const Scene& scene, const std::string& reason) {
  const Result<Renderer> result = Renderer::create(scene);
  REQUIRE_FALSE(result.ok());
  CHECK(result.error() == reason);
}

}  // namespace

TEST_CASE("a picture does not depend on what was in its memory before") {
  Random random(31);
  Picture reused;
  for (const auto& [width, height] : {std::pair{64, 64}, {203, 97}, {1, 1}, {5, 130}, {64, 64}}) {
    const Scene scene = mixed_scene(width, height);
    const Renderer renderer = renderer_of(scene);
    for (int view = 0; view < 5; ++view) {
      const Camera camera = camera_at(scene.studio, random.direction());
      Picture fresh;
      renderer.render(camera, fresh);
      fill_with_garbage(reused);
      renderer.render(camera, reused);
      REQUIRE(fresh.rgb.size() == static_cast<std::size_t>(3 * width * height));
      REQUIRE(same_bytes(fresh, reused));
    }
  }
}

TEST_CASE("a picture of the same size needs no new memory") {
  const Scene scene = mixed_scene(128, 128);
  const Renderer renderer = renderer_of(scene);
  Picture picture;
  renderer.render(camera_at(scene.studio, {1, 0, 0}), picture);
  const std::uint8_t* rgb = picture.rgb.data();
  const float* depth = picture.depth.data();
  const std::int32_t* tiles = picture.tiles.row(0);
  renderer.render(camera_at(scene.studio, {0, 0, 1}), picture);
  CHECK(picture.rgb.data() == rgb);
  CHECK(picture.depth.data() == depth);
  CHECK(picture.tiles.row(0) == tiles);
}

TEST_CASE("threads and renderers of the same scene give the same bytes") {
  for (const bool lit : {false, true}) {
    Scene scene = mixed_scene(150, 150);
    if (lit) scene.lights.push_back({{1, 2, 1}, {0.5, 0.5, 0.5}, true});
    const Renderer one = renderer_of(scene), other = renderer_of(scene);
    constexpr int kViews = 30;
    const auto render_all = [&](const Renderer& renderer, std::vector<Picture>& pictures) {
      Random random(32);
      for (Picture& picture : pictures)
        renderer.render(camera_at(scene.studio, random.direction()), picture);
    };
    std::vector<Picture> first(kViews), second(kViews), third(kViews);
    std::thread thread([&] { render_all(one, first); });
    render_all(one, second);
    thread.join();
    render_all(other, third);
    for (std::size_t k = 0; k < kViews; ++k) {
      REQUIRE(same_bytes(first[k], second[k]));
      REQUIRE(same_bytes(first[k], third[k]));
    }
  }
}

TEST_CASE("the background is its colour, id 0 and infinitely far") {
  Scene scene = mixed_scene(100, 80);
  scene.studio.background = {0.2, 0.5, 1};
  const Renderer renderer = renderer_of(scene);
  Picture picture;
  renderer.render(camera_at(scene.studio, Vector3d(1, 1, 1).normalized()), picture);
  int background = 0;
  for (std::size_t k = 0; k < picture.surface.size(); ++k) {
    if (picture.surface[k] != 0) {
      REQUIRE(std::isfinite(picture.depth[k]));
      continue;
    }
    ++background;
    REQUIRE(picture.rgb[3 * k] == 51);
    REQUIRE(picture.rgb[3 * k + 1] == 128);
    REQUIRE(picture.rgb[3 * k + 2] == 255);
    REQUIRE(picture.depth[k] == std::numeric_limits<float>::infinity());
  }
  CHECK(background > 2000);
}

TEST_CASE("without lights a surface has one colour, rounded to 8 bits and cut off at 1") {
  Scene scene = empty_scene(64, 64);
  add_shape(scene, Sphere{{0, 0, 0}, 0.3});
  scene.studio.ambient = {0.5, 1, 3};
  scene.surfaces[0] = {{1, 1, 1}, {0.3, 0.85, 0.5}};
  const Renderer renderer = renderer_of(scene);
  Picture picture;
  renderer.render(camera_at(scene.studio, {0, 1, 0}), picture);
  for (std::size_t k = 0; k < picture.surface.size(); ++k)
    if (picture.surface[k] == 1) {
      REQUIRE(picture.rgb[3 * k] == 38);
      REQUIRE(picture.rgb[3 * k + 1] == 217);
      REQUIRE(picture.rgb[3 * k + 2] == 255);
    }
  CHECK(picture.surface[32 * 64 + 32] == 1);
}

TEST_CASE("the foreground box holds every pixel that is not background, and little more") {
  Random random(33);
  const Scene scene = mixed_scene(300, 200);
  const Renderer renderer = renderer_of(scene);
  Picture picture;
  for (int view = 0; view < 50; ++view) {
    renderer.render(camera_at(scene.studio, random.direction(), random.uniform(0.6, 2)), picture);
    int x0 = 300, y0 = 200, x1 = 0, y1 = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 300; ++x) {
        if (picture.surface[static_cast<std::size_t>(y * 300 + x)] == 0) continue;
        x0 = std::min(x0, x), x1 = std::max(x1, x + 1);
        y0 = std::min(y0, y), y1 = std::max(y1, y + 1);
      }
    const Box& box = picture.foreground;
    REQUIRE(box.x <= x0);
    REQUIRE(box.y <= y0);
    REQUIRE(box.x + box.width >= x1);
    REQUIRE(box.y + box.height >= y1);
    REQUIRE(box.width - (x1 - x0) < 30);
    REQUIRE(box.height - (y1 - y0) < 30);
  }
}

TEST_CASE("what lies behind the camera or beside the picture leaves it empty") {
  Scene scene = empty_scene(64, 64);
  add_shape(scene, Sphere{{0, 0, 0}, 0.1});
  const Renderer renderer = renderer_of(scene);
  Picture picture;
  for (const Vector3d& target : {Vector3d(0, 0, 5), {3, 0, -1}}) {
    scene.studio.at = target;
    renderer.render(camera_at(scene.studio, {0, 0, -1}), picture);
    CHECK(picture.foreground.empty());
    CHECK(std::count(picture.surface.begin(), picture.surface.end(), 0) == 64 * 64);
  }
}

TEST_CASE("scenes that cannot be rendered are refused with the reason") {
  Scene scene = empty_scene(64, 64);
  require_refused(scene, "test: nothing to render; a scene needs a primitive");
  add_shape(scene, Sphere{{0, 0, 0}, 0.1});
  REQUIRE(Renderer::create(scene).ok());

  Scene broken = scene;
  broken.primitives[0].surface = 1;
  require_refused(broken, "test: primitive 0 has surface 1; there are 1");
  broken = scene;
  add_shape(broken, Polygon{{{0, 0, 0}, {1, 0, 0}}});
  require_refused(broken, "test: primitive 1 has a polygon of fewer than 3 vertices");
  broken = scene;
  add_shape(broken, Cone{{1, 2, 3}, {1, 2, 3}, 1, 1});
  require_refused(broken, "test: primitive 1 has a cone without length");
  broken = scene;
  add_shape(broken, Sphere{{0, std::numeric_limits<double>::quiet_NaN(), 0}, 1});
  require_refused(broken, "test: primitive 1 has a number that is not finite");
  broken = scene;
  add_shape(broken, Mesh{});
  require_refused(broken, "test: primitive 1 has a mesh without triangles");
  broken = scene;
  add_shape(broken, Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}});
  require_refused(broken, "test: primitive 1 has a mesh with a vertex that is not there");
  broken = scene;
  broken.primitives.resize(65535, scene.primitives[0]);
  require_refused(broken, "test: 65535 primitives; at most 65534 can be told apart");
}

TEST_CASE("the last of 65534 primitives has its own id") {
  Scene scene = empty_scene(32, 32);
  add_shape(scene, Sphere{{5, 0, 0}, 0.01});
  scene.primitives.resize(65534, scene.primitives[0]);
  scene.primitives.back().shape = Sphere{{0, 0, 0}, 0.2};
  Picture picture;
  renderer_of(scene).render(camera_at(scene.studio, {0, 0, 1}), picture);
  CHECK(picture.surface[16 * 32 + 16] == 65534);
}
