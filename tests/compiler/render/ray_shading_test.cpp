// The rules of mirrors, glass, highlights and lights that POV-Ray does not share, against their
// formulas; what it shares is in povray_test.cpp.
#include "compiler/render/ray_shading.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "compiler/scene/bob_reader.h"
#include "compiler/scene/ear_clipping.h"
#include "tests/compiler/render/test_scenes.h"

using namespace aspect;
using Eigen::Vector3d;

namespace {

constexpr const char* kFloor =
    " polygon { points 4 vertex -9 -9 0 vertex 9 -9 0 vertex 9 9 0 vertex -9 9 0 } ";

// Shades single rays of a scene, without a picture.
class RayScene {
 public:
  explicit RayScene(const std::string& text)
      : scene_(parsed(text)), shading_(scene_), embree_(built(scene_)) {}

  Vector3d color(const Vector3d& from, const Vector3d& to, const SampleKey& key = {}) const {
    return shading_.color(embree_, {from, to - from}, key);
  }
  // Of the floor, looked at from above.
  Vector3d floor(double x, double y) const { return color({x, y, 2}, {x, y, 0}); }

 private:
  static Scene parsed(const std::string& text) {
    Result<Scene> scene = parse_bob(text, "s.b");
    if (!scene) FAIL(scene.error());
    return std::move(scene).value();
  }
  static EmbreeScene built(const Scene& scene) {
    std::vector<std::vector<Triangle>> triangles(scene.primitives.size());
    for (std::size_t k = 0; k < triangles.size(); ++k)
      if (const auto* polygon = std::get_if<Polygon>(&scene.primitives[k].shape))
        triangles[k] = triangulate(polygon->vertices);
    Result<EmbreeScene> result = EmbreeScene::create(scene, triangles);
    if (!result) FAIL(result.error());
    return std::move(result).value();
  }

  Scene scene_;
  RayShading shading_;
  EmbreeScene embree_;
};

void require_color(const Vector3d& found, const Vector3d& expected, double tolerance = 1e-5) {
  INFO(found.transpose() << " instead of " << expected.transpose());
  REQUIRE((found - expected).cwiseAbs().maxCoeff() <= tolerance);
}

}  // namespace

TEST_CASE("between a spot's two cones its light is linear in the cosine") {
  const RayScene scene(
      std::string("light { position 0 0 1 at 0 0 0 min_angle 40 max_angle 80 color "
                  "1 .5 .25 }") +
      kFloor);
  const double inner = std::cos(20 * std::numbers::pi / 180);
  const double outer = std::cos(40 * std::numbers::pi / 180);
  for (double x = 0.01; x < 1.5; x += 0.05) {
    const double cosine = 1 / std::hypot(1, x);
    const double share = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    require_color(scene.floor(x, 0), share * cosine * Vector3d(1, .5, .25));
  }
}

TEST_CASE("light falls off by the distance, by its square or not at all") {
  for (const int falloff : {0, 1, 2}) {
    const RayScene scene("light { position 0 0 2 falloff " + std::to_string(falloff) + " }" +
                         kFloor);
    const double distance = std::hypot(2, 1);
    require_color(scene.floor(0, 1),
                  Vector3d::Constant(2 / distance / std::pow(distance, falloff)));
  }
}

TEST_CASE("a highlight has its own colour and Phong's power, on the light's side alone") {
  const RayScene scene(std::string("light { position 2 0 1 color .5 1 1 } surface { diffuse 0 0 0 "
                                   "shine 7 .2 .4 .8 }") +
                       kFloor);
  const Vector3d bounced = Vector3d(1, 0, 1).normalized();
  const Vector3d seen = Vector3d(.7, .3, 0), from = seen - bounced.cwiseProduct(Vector3d(1, 1, -1));
  const double cosine = bounced.dot((Vector3d(2, 0, 1) - seen).normalized());
  require_color(scene.color(from, seen), std::pow(cosine, 7) * Vector3d(.1, .4, .8));
  require_color(scene.color({from.x(), from.y(), -from.z()}, seen), Vector3d::Zero());
  require_color(scene.color({3, 0, .2}, seen), Vector3d::Zero());  // bounced away from the light
}

TEST_CASE("light through glass fades by the length of its way, and at once with no_exp_trans") {
  const std::string slab =
      "surface { diffuse 0 0 0 ambient 0 0 0 transparent .5 1 0 } "
      "polygon { points 4 vertex -3 -3 .2 vertex 3 -3 .2 vertex 3 3 .2 vertex -3 3 .2 } "
      "polygon { points 4 vertex -3 -3 .6 vertex 3 -3 .6 vertex 3 3 .6 vertex -3 3 .6 } ";
  const std::string lamp = " light { position 0 0 1 } surface { diffuse 1 1 1 } ";
  const double way = .4 * std::hypot(1, .75);
  const double cosine = 1 / std::hypot(1, .75);
  const Vector3d from(0, .75, .1), to(0, .75, 0);
  const RayScene fading("studio { } " + lamp + kFloor + slab);
  require_color(fading.color(from, to), cosine * Vector3d(std::pow(.5, way), 1, 0));
  const RayScene tinted("studio { no_exp_trans } " + lamp + kFloor + slab);
  require_color(tinted.color(from, to), cosine * Vector3d(.5, 1, 0));
}

TEST_CASE("what lies behind glass is seen faded, and nothing through a black part") {
  const std::string scene = "surface { diffuse 0 0 0 ambient 1 1 1 } " + std::string(kFloor) +
                            "surface { diffuse 0 0 0 ambient 0 0 0 transparent .25 .5 0 ior 1 } "
                            "sphere { center 0 0 1 radius .5 } ";
  require_color(RayScene("studio { ambient 1 1 1 } " + scene).floor(0, 0), {.25, .5, 0});
  require_color(RayScene("studio { ambient 1 1 1 no_exp_trans } " + scene).floor(0, 0),
                {.25, .5, 0});
}

TEST_CASE("a surface with no_shadow leaves the light alone") {
  const std::string before = std::string("light { position 0 0 1 } ") + kFloor;
  const std::string plate =
      "polygon { points 3 vertex -.1 -.1 .5 vertex .2 -.1 .5 vertex -.1 .2 .5 } ";
  CHECK(RayScene(before + plate).color({0, 0, .4}, {0, 0, 0}).isZero(0));
  require_color(RayScene(before + "surface { no_shadow } " + plate).color({0, 0, .4}, {0, 0, 0}),
                {1, 1, 1});
}

TEST_CASE("a directional light shines along its direction from any distance") {
  const RayScene scene(std::string("light { type directional direction 3 0 -4 color .5 .5 .5 } ") +
                       kFloor + "sphere { center -6 0 8 radius .5 }");
  require_color(scene.floor(5, 0), Vector3d::Constant(.4));
  require_color(scene.color({0, 0, 1}, {0, 0, 0}), Vector3d::Zero());
}

TEST_CASE("half of a spherical light's disc lights half as much") {
  const RayScene scene(std::string("light { type spherical center 0 0 2 radius .2 samples 400 } ") +
                       kFloor +
                       "polygon { points 4 vertex 0 -1 1.5 vertex 1 -1 1.5 vertex 1 1 1.5 vertex "
                       "0 1 1.5 }");
  require_color(scene.color({0, 0, 1}, {0, 0, 0}), Vector3d::Constant(.5), .02);
  require_color(scene.color({-1, 0, 1}, {-1, 0, 0}), Vector3d::Constant(2 / std::hypot(2, 1)), .02);
}

TEST_CASE("two mirrors face each other to the depth the studio allows") {
  const std::string mirrors =
      "surface { diffuse 0 0 0 ambient .1 .1 .1 specular .5 .5 .5 } " + std::string(kFloor) +
      "polygon { points 4 vertex -9 -9 1 vertex 9 -9 1 vertex 9 9 1 vertex -9 9 1 } ";
  for (const int depth : {0, 1, 2, 5}) {
    const RayScene scene("studio { ambient 1 1 1 depth " + std::to_string(depth) + " } " + mirrors);
    const double sum = .1 * (1 - std::pow(.5, depth + 1)) / .5;
    require_color(scene.color({0, 0, .5}, {.1, 0, 0}), Vector3d::Constant(sum));
  }
}

TEST_CASE("mirrors inside glass inside mirrors end") {
  const RayScene scene(
      "studio { ambient 1 1 1 depth 100 no_exp_trans } surface { ambient .01 .01 .01 specular 1 1 "
      "1 "
      "transparent 1 1 1 ior 1.5 } sphere { center 0 0 0 radius 1 } sphere { center 0 0 0 radius "
      "2 } sphere { center 0 0 3 radius .9 }");
  CHECK(scene.color({5, 1, 1}, {0, 0, 0}).allFinite());
}

TEST_CASE("fuzz blurs a mirror around what it shows, the same way every time") {
  const std::string around =
      "studio { background 0 0 0 ambient 1 1 1 } surface { ambient 1 1 1 } "
      "polygon { points 4 vertex 0 -90 9 vertex 90 -90 9 vertex 90 90 9 vertex 0 90 9 } ";
  const RayScene fuzzy(around + "surface { diffuse 0 0 0 specular 1 1 1 fuzz .2 } " + kFloor);
  double sum = 0;
  for (int k = 0; k < 2000; ++k) {
    const SampleKey key(k, 0);
    const Vector3d color = fuzzy.color({0, 0, 1}, {0, 0, 0}, key);
    CHECK(color == fuzzy.color({0, 0, 1}, {0, 0, 0}, key));
    sum += color.x() / 2000;
  }
  CHECK(sum == Approx(.5).margin(.04));
  const RayScene slight(around + "surface { diffuse 0 0 0 specular 1 1 1 fuzz .01 } " + kFloor);
  for (int k = 0; k < 100; ++k) {
    CHECK(slight.color({1, 0, 1}, {1, 0, 0}, SampleKey(k, 1)).x() == Approx(1));
    CHECK(slight.color({-1, 0, 1}, {-1, 0, 0}, SampleKey(k, 2)).x() == 0);
  }
}

TEST_CASE("haze mixes in the background by the length of the way, but not in glass") {
  const std::string scene =
      "studio { ambient 1 1 1 background 0 0 1 haze .3 } surface { diffuse 1 "
      "0 0 } ";
  const double clear = std::pow(.7, 2);
  require_color(RayScene(scene + kFloor).floor(0, 0), {clear, 0, 1 - clear});
  const RayScene glass(scene + kFloor +
                       "surface { diffuse 0 0 0 ambient 0 0 0 transparent 1 1 1 } sphere { center "
                       "0 0 1 radius .5 }");
  const double shorter = .7;
  require_color(glass.floor(0, 0), {shorter, 0, 1 - shorter});
}
