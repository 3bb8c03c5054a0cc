// Antialiasing, jitter, the lens and parallel rays: what they leave alone, and what they average.
#include "compiler/render/pixel_sampling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <thread>

#include "compiler/scene/bob_reader.h"
#include "tests/compiler/render/picture_check.h"
#include "tests/compiler/render/test_scenes.h"

using namespace aspect;
using Eigen::Vector3d;

namespace {

constexpr const char* kHalves =
    "surface { diffuse 1 1 1 } polygon { points 4 vertex -1 -9 0 vertex .0037 -9 0 vertex .0037 9 "
    "0 "
    "vertex -1 9 0 } ";
constexpr const char* kEverything =
    "light { type spherical center .5 .3 1 radius .2 samples 5 } "
    "surface { diffuse .5 .5 .5 specular .3 .3 .3 fuzz .1 texture { checker scale .05 } } "
    "polygon { points 4 vertex -.3 -.3 0 vertex .3 -.3 0 vertex .3 .3 0 vertex -.3 .3 0 } "
    "surface { transparent .5 .5 .5 ior 1.3 } sphere { center 0 0 .15 radius .14 } "
    "surface { diffuse 1 .2 .2 shine 5 no_antialias } cone { base .2 .2 0 apex .2 .2 .2 radius .05 "
    "} ";

Scene scene_of(const std::string& text) {
  Result<Scene> scene = parse_bob(text, "s.b");
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

Picture picture_of(const Scene& scene, const Vector3d& direction) {
  Picture picture;
  renderer_of(scene).render(camera_at(scene.studio, direction.normalized()), picture);
  return picture;
}

std::string studio(const std::string& more) {
  return "studio { up 0 1 0 resolution 40 40 ambient 1 1 1 angle 45 " + more + " } ";
}

// The border of kHalves in pixels from the left.
double border_px(const Scene& scene) {
  const Camera camera = camera_at(scene.studio, {0, 0, 1});
  return camera.intrinsics.cx_px + .0037 * camera.intrinsics.fx_px + 0.5;
}

}  // namespace

TEST_CASE("ids and depths are those of the pixels' centres whatever the antialiasing") {
  const Picture plain = picture_of(scene_of(studio("") + kEverything), {1, .5, 1.5});
  for (const char* how : {"antialias quick", "antialias corners jitter", "antialias adaptive",
                          "antialias adaptive jitter samples 16", "aperture .05 samples 4"}) {
    const Picture picture = picture_of(scene_of(studio(how) + kEverything), {1, .5, 1.5});
    INFO(how);
    CHECK(picture.surface == plain.surface);
    CHECK(picture.depth == plain.depth);
    CHECK(picture.rgb != plain.rgb);
  }
}

TEST_CASE("threads give the same bytes of samples of every kind") {
  const Scene scene =
      scene_of(studio("antialias adaptive jitter threshold 4 aperture .03 samples 16 haze .1") +
               kEverything);
  const Renderer one = renderer_of(scene), other = renderer_of(scene);
  const Camera camera = camera_at(scene.studio, Vector3d(1, .5, 1.5).normalized());
  Picture first, second, third;
  std::thread thread([&] { one.render(camera, first); });
  one.render(camera, second);
  thread.join();
  other.render(camera, third);
  CHECK(same_bytes(first, second));
  CHECK(same_bytes(first, third));
}

TEST_CASE("a pixel that a border crosses shows its share: of corners, or of finer pieces") {
  const Scene plain = scene_of(studio("") + kHalves);
  const double border = border_px(plain);
  const int column = static_cast<int>(border);
  const double share = border - column;
  REQUIRE(share > .1);
  REQUIRE(share < .4);
  const auto level = [&](const char* how) {
    const Picture picture = picture_of(scene_of(studio(how) + kHalves), {0, 0, 1});
    const std::size_t row = 20 * 40;
    CHECK(picture.rgb[3 * (row + static_cast<std::size_t>(column) - 1)] == 255);
    CHECK(picture.rgb[3 * (row + static_cast<std::size_t>(column) + 1)] == 0);
    return picture.rgb[3 * (row + static_cast<std::size_t>(column))] / 255.0;
  };
  CHECK(level("antialias none") == 0);
  CHECK(level("antialias quick") == Approx(.5).margin(.01));
  CHECK(level("antialias corners") == Approx(.5).margin(.01));
  CHECK(level("antialias adaptive threshold 0") == Approx(share).margin(1 / 16.0));
  CHECK(level("antialias adaptive threshold 0 samples 1") == Approx(.5).margin(.01));
  CHECK(level("antialias adaptive threshold 255") == Approx(.5).margin(.01));
}

TEST_CASE("pixels that show no_antialias surfaces alone are left whole") {
  const std::string checker =
      "polygon { points 4 vertex -9 -9 0 vertex 9 -9 0 vertex 9 9 0 vertex -9 9 0 }";
  const std::string texture = " texture { checker scale .03 }";
  const auto greys = [&](const std::string& surface) {
    const Picture picture =
        picture_of(scene_of(studio("antialias adaptive") + "surface {" + surface + " } " + checker),
                   {0, 0, 1});
    return std::count_if(picture.rgb.begin(), picture.rgb.end(),
                         [](std::uint8_t c) { return c != 0 && c != 255; });
  };
  CHECK(greys(texture) > 500);
  CHECK(greys(texture + " no_antialias") == 0);
}

TEST_CASE("a lens is sharp at the focal length and blurs a border beyond by its disc") {
  const auto width_of_border = [&](const std::string& how) {
    const Picture picture = picture_of(scene_of(studio(how + " samples 400") + kHalves), {0, 0, 1});
    int blurred = 0;
    for (std::size_t x = 0; x < 40; ++x) {
      const std::uint8_t level = picture.rgb[3 * (20 * 40 + x)];
      if (level > 2 && level < 253) ++blurred;
    }
    return blurred;
  };
  CHECK(width_of_border("aperture .1") <= 1);
  CHECK(width_of_border("aperture .1 focal_length 1") <= 1);
  // The disc of radius R in the plane at distance 1, seen through the focal plane at distance F:
  // 2 R |1 / F - 1| units wide.
  const double fx_px = 40 / (2 * std::tan(22.5 * M_PI / 180));
  for (const double focal : {.5, 2.0})
    CHECK(width_of_border("aperture .1 focal_length " + std::to_string(focal)) ==
          Approx(.2 * std::abs(1 / focal - 1) * fx_px).margin(1.6));
}

TEST_CASE("the foreground box holds every pixel that antialiasing or a lens colours") {
  for (const char* how : {"antialias adaptive", "aperture .1 focal_length .5 samples 50"}) {
    const Scene scene = scene_of(studio(how) + "sphere { center .1 0 0 radius .1 }");
    const Picture picture = picture_of(scene, {0, 0, 1});
    REQUIRE_FALSE(picture.foreground.empty());
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        const Box& box = picture.foreground;
        const bool inside =
            x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
        if (!inside) REQUIRE(picture.rgb[static_cast<std::size_t>(3 * (y * 40 + x))] == 0);
      }
    CHECK(picture.foreground.width < 35);
  }
}

TEST_CASE("an orthogonal picture's ids and depths are right from random directions") {
  Random random(41);
  Scene scene = empty_scene(120, 90);
  scene.studio.projection = Projection::kOrthogonal;
  scene.studio.width = .9;
  add_box(scene, {-0.2, -0.1, -0.1}, {0.2, 0.1, 0.1});
  add_shape(scene, Cone{{0, 0.1, 0}, {0, 0.3, 0}, 0.07, 0.05});
  add_shape(scene, Ring{{0, 0.3, 0}, {0, 1, 0}, 0, 0.05});
  add_shape(scene, Sphere{{0.2, 0, 0.1}, 0.08});
  add_shape(scene, SmoothTriangle{{{{-.3, -.3, 0}, {0, -.3, .1}, {-.2, -.1, 0}}},
                                  {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}});
  const Renderer renderer = renderer_of(scene);
  for (int k = 0; k < 10; ++k)
    require_like_reference(scene, renderer, camera_at(scene.studio, random.direction()));
}

TEST_CASE("an orthogonal camera's pixels are as wide as the studio says, at every depth") {
  Studio flat;
  flat.projection = Projection::kOrthogonal;
  flat.width = 2;
  flat.width_px = 100;
  flat.height_px = 50;
  flat.aspect = 2;
  const Camera camera = camera_at(flat, {0, 0, 1});
  CHECK(camera.intrinsics.fx_px == Approx(50));
  CHECK(camera.intrinsics.fy_px == Approx(50));
  for (const double depth : {.5, 3.0}) {
    const Vector3d point = camera.intrinsics.point_camera(99.5, 49.5, depth);
    CHECK(point.isApprox(Vector3d(1, .5, depth)));
    const ViewRay ray = view_ray(camera, 99.5, 49.5);
    const Vector3d seen = ray.origin_object + depth * ray.direction_object;
    CHECK((camera.camera_from_object * (seen - camera.position_object)).isApprox(point));
  }
}

TEST_CASE("smooth triangles are right from random directions") {
  Random random(42);
  Scene scene = empty_scene(120, 120);
  for (int k = 0; k < 8; ++k) {
    const Vector3d normal = random.direction();
    add_shape(scene, SmoothTriangle{{{random.point(.3), random.point(.3), random.point(.3)}},
                                    {{normal, normal, normal}}});
  }
  const Renderer renderer = renderer_of(scene);
  for (int k = 0; k < 6; ++k)
    require_like_reference(scene, renderer, camera_at(scene.studio, random.direction()));
}
