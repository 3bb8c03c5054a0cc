#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <string>

#include "scene_samples.h"

namespace aspect {
namespace {

constexpr const char* kBall = "sphere { center 0 0 0 radius .1 }";

}  // namespace

TEST_CASE("a studio has the format's defaults") {
  for (const char* text : {"", "studio { }"}) {
    const Studio studio = scene_of(text).studio;
    CHECK(studio.at == Eigen::Vector3d(0, 0, 0));
    CHECK(studio.up == Eigen::Vector3d(0, 0, 1));
    CHECK(studio.angle_deg == 45);
    CHECK(studio.width_px == 512);
    CHECK(studio.height_px == 512);
    CHECK(studio.aspect == 1);
    CHECK(studio.ambient == Eigen::Vector3d(0, 0, 0));
    CHECK(studio.background == Eigen::Vector3d(0, 0, 0));
  }
}

TEST_CASE("the thesis's studio is read") {
  const Scene scene = scene_of(
      "studio {\n at 0 0 0\n up 0 1 0.05\n angle 50\n resolution 128 64\n antialias none\n"
      " threshold 1\n aspect 1.5\n ambient 1 1 1 background .1 .2 .3\n}");
  CHECK(scene.studio.up == Eigen::Vector3d(0, 1, .05));
  CHECK(scene.studio.angle_deg == 50);
  CHECK(scene.studio.width_px == 128);
  CHECK(scene.studio.height_px == 64);
  CHECK(scene.studio.aspect == 1.5);
  CHECK(scene.studio.ambient == Eigen::Vector3d(1, 1, 1));
  CHECK(scene.studio.background == Eigen::Vector3d(.1, .2, .3));
  CHECK(scene.warnings.empty());
}

TEST_CASE("the aspect follows from the resolution") {
  CHECK(scene_of("studio { resolution 640 480 }").studio.aspect == Approx(4.0 / 3));
}

TEST_CASE("studio fields that change nothing here are accepted") {
  const Scene scene = scene_of(
      "studio { samples 4 jitter depth 5 no_exp_trans caustics haze 0 aperture 0 focal_length 1 "
      "project perspective }");
  CHECK(scene.warnings.empty());
}

TEST_CASE("a studio's camera position is accepted with a warning") {
  const Scene scene = scene_of("studio {\n from 0 0 5 }");
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0] == "s.b:2: from has no effect; leave it out");
}

TEST_CASE("a light stands where it is put and casts shadows") {
  const Scene scene = scene_of(
      "light { type point position 1 2 3 color .5 .6 .7 falloff 0 } light { center 4 5 6 "
      "no_shadows }");
  REQUIRE(scene.lights.size() == 2);
  CHECK(scene.lights[0].position == Eigen::Vector3d(1, 2, 3));
  CHECK(scene.lights[0].color == Eigen::Vector3d(.5, .6, .7));
  CHECK(scene.lights[0].casts_shadows);
  CHECK(scene.lights[1].position == Eigen::Vector3d(4, 5, 6));
  CHECK(scene.lights[1].color == Eigen::Vector3d(1, 1, 1));
  CHECK_FALSE(scene.lights[1].casts_shadows);
}

TEST_CASE("a studio can switch all shadows off, before or behind the lights") {
  for (const char* text : {"studio { no_shadows } light { position 0 0 1 }",
                           "light { position 0 0 1 } studio { no_shadows }"}) {
    CHECK_FALSE(scene_of(text).lights.at(0).casts_shadows);
  }
}

TEST_CASE("a light moves with the transform around it") {
  const Scene scene =
      scene_of("transform { translate 1 2 3 } light { position 1 1 1 } transform_pop");
  CHECK(scene.lights.at(0).position == Eigen::Vector3d(2, 3, 4));
}

TEST_CASE("a surface holds for what follows until the next") {
  const std::string ball = kBall;
  const Scene scene = scene_of(ball + "surface { diffuse 1 0 0 }" + ball + ball +
                               "surface { ambient 0 0 1 diffuse 0 1 0 }" + ball);
  REQUIRE(scene.primitives.size() == 4);
  REQUIRE(scene.surfaces.size() == 3);
  CHECK(scene.primitives[0].surface == 0);
  CHECK(scene.primitives[1].surface == 1);
  CHECK(scene.primitives[2].surface == 1);
  CHECK(scene.primitives[3].surface == 2);
  CHECK(scene.surfaces[0].diffuse == Eigen::Vector3d(1, 1, 1));
  CHECK(scene.surfaces[1].diffuse == Eigen::Vector3d(1, 0, 0));
  CHECK(scene.surfaces[1].ambient == Eigen::Vector3d(1, 0, 0));
  CHECK(scene.surfaces[2].diffuse == Eigen::Vector3d(0, 1, 0));
  CHECK(scene.surfaces[2].ambient == Eigen::Vector3d(0, 0, 1));
}

TEST_CASE("surface fields without effect on flat colours warn or pass") {
  const Scene scene =
      scene_of("surface { specular 0 0 0 transparent 0 0 0 fuzz 0\n ior 1.5\n no_antialias }");
  REQUIRE(scene.warnings.size() == 2);
  CHECK(scene.warnings[0] == "s.b:2: ior has no effect; leave it out");
  CHECK(scene.warnings[1] == "s.b:3: no_antialias has no effect; leave it out");
}

TEST_CASE("colours out of 0..1 are kept with a warning") {
  const Scene scene = scene_of(
      "surface {\n diffuse 1.5 0 0 }\nlight { position 0 0 1 color 0 -1 0 }\n"
      "studio { ambient 1 1 1 background 0 0 2 }" +
      std::string(kBall));
  CHECK(scene.surfaces.at(0).diffuse == Eigen::Vector3d(1.5, 0, 0));
  REQUIRE(scene.warnings.size() == 3);
  CHECK(scene.warnings[0] == "s.b:2: diffuse 1.5 0 0 is out of 0..1; write parts of 1");
  CHECK(scene.warnings[1] == "s.b:3: color 0 -1 0 is out of 0..1; write parts of 1");
  CHECK(scene.warnings[2] == "s.b:4: background 0 0 2 is out of 0..1; write parts of 1");
}

TEST_CASE("warnings past a hundred are left out") {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "surface { diffuse 2 2 2 }\n";
  const Scene scene = scene_of(text);
  REQUIRE(scene.warnings.size() == 101);
  CHECK(scene.warnings.back() == "s.b:101: more warnings are left out; mend the first ones");
}

TEST_CASE("a polygon keeps its vertices in order, convex or not") {
  const Scene scene =
      scene_of("polygon { points 4 vertex 0 0 0 vertex .2 0 0 vertex .05 .05 0 vertex 0 .2 0 }");
  const Polygon& polygon = shape_of<Polygon>(scene);
  REQUIRE(polygon.vertices.size() == 4);
  CHECK(polygon.vertices[2] == Eigen::Vector3d(.05, .05, 0));
}

TEST_CASE("a polygon may be off its plane by less than the scene's decimals") {
  CHECK(
      scene_of("polygon { points 4 vertex 0 0 0 vertex .2 0 0 vertex .2 .2 .00001 vertex 0 .2 0 }")
          .primitives.size() == 1);
}

TEST_CASE("a ring is an annulus or a disc") {
  const Scene scene = scene_of(
      "ring { center 0 0 .1 normal 0 0 3 min_radius .1 max_radius .2 }"
      "ring { center 0 0 .1 normal 0 4 3 radius .2 }");
  CHECK(shape_of<Ring>(scene, 0).min_radius == .1);
  CHECK(shape_of<Ring>(scene, 0).max_radius == .2);
  CHECK(shape_of<Ring>(scene, 0).normal == Eigen::Vector3d(0, 0, 1));
  CHECK(shape_of<Ring>(scene, 1).min_radius == 0);
  CHECK(shape_of<Ring>(scene, 1).max_radius == .2);
  CHECK(shape_of<Ring>(scene, 1).normal.isApprox(Eigen::Vector3d(0, .8, .6)));
}

TEST_CASE("cones and cylinders are the same statement") {
  const Scene scene = scene_of(
      "cone { base 0 0 0 base_radius .2 apex 0 0 .1 apex_radius 0 }"
      "cone { base 0 0 0 apex 0 0 .1 radius .2 } cylinder { base 0 0 0 apex 0 0 .1 radius .2 }");
  CHECK(shape_of<Cone>(scene, 0).base_radius == .2);
  CHECK(shape_of<Cone>(scene, 0).apex_radius == 0);
  for (const std::size_t i : {1U, 2U}) {
    CHECK(shape_of<Cone>(scene, i).base_radius == .2);
    CHECK(shape_of<Cone>(scene, i).apex_radius == .2);
    CHECK(shape_of<Cone>(scene, i).apex == Eigen::Vector3d(0, 0, .1));
  }
}

TEST_CASE("the steps of a transform apply in the order written") {
  const std::string point = "sphere { center 1 0 0 radius 1 } transform_pop";
  const auto moved = [&](const std::string& steps) {
    return shape_of<Sphere>(scene_of("transform { " + steps + " }" + point)).center;
  };
  CHECK(moved("translate 0 -2 0 scale 2") == Eigen::Vector3d(2, -4, 0));
  CHECK(moved("scale 2 translate 0 -2 0") == Eigen::Vector3d(2, -2, 0));
  CHECK(moved("rotate 0 0 90") == Eigen::Vector3d(0, 1, 0));
  CHECK(moved("rotate 0 90 0") == Eigen::Vector3d(0, 0, -1));
  CHECK(moved("rotate 0 0 90 rotate 90 0 0") == Eigen::Vector3d(0, 0, 1));
  CHECK(moved("") == Eigen::Vector3d(1, 0, 0));
}

TEST_CASE("one rotate turns about x, then y, then z") {
  const Scene scene =
      scene_of("transform { rotate 90 0 90 } sphere { center 0 1 0 radius 1 } transform_pop");
  CHECK(shape_of<Sphere>(scene).center == Eigen::Vector3d(0, 0, 1));
}

TEST_CASE("a nested transform applies before its outer one and ends at its pop") {
  const Scene scene = scene_of(
      "transform { scale 2 } transform { translate 1 0 0 rotate 0 0 90 }"
      "sphere { center 0 0 0 radius 1 } transform_pop sphere { center 1 0 0 radius 1 }"
      "transform_pop sphere { center 1 0 0 radius 1 }");
  CHECK(shape_of<Sphere>(scene, 0).center == Eigen::Vector3d(0, 2, 0));
  CHECK(shape_of<Sphere>(scene, 0).radius == 2);
  CHECK(shape_of<Sphere>(scene, 1).center == Eigen::Vector3d(2, 0, 0));
  CHECK(shape_of<Sphere>(scene, 2).center == Eigen::Vector3d(1, 0, 0));
}

TEST_CASE("a polygon may be scaled unevenly, by signed factors with the sign rule") {
  const Scene scene = scene_of(
      "transform { scale 2 -1 3 } polygon { points 3 vertex 1 1 1 vertex 0 0 0 vertex 0 1 0 } "
      "transform_pop");
  CHECK(shape_of<Polygon>(scene).vertices[0] == Eigen::Vector3d(2, -1, 3));
}

TEST_CASE("round primitives turn, shrink and mirror with their transform") {
  const Scene scene = scene_of(
      "transform { rotate 90 0 0 scale .5 scale -1 1 1 }"
      "ring { center 2 0 0 normal 0 1 0 min_radius .2 max_radius 1 }"
      "cone { base 0 0 0 apex 2 2 0 base_radius 1 apex_radius 0 } transform_pop");
  const Ring& ring = shape_of<Ring>(scene, 0);
  CHECK(ring.center == Eigen::Vector3d(-1, 0, 0));
  CHECK(ring.normal.isApprox(Eigen::Vector3d(0, 0, 1)));
  CHECK(ring.min_radius == .1);
  CHECK(ring.max_radius == .5);
  CHECK(shape_of<Cone>(scene, 1).apex.isApprox(Eigen::Vector3d(-1, 0, 1)));
  CHECK(shape_of<Cone>(scene, 1).base_radius == .5);
}

TEST_CASE("uneven scales that cancel out leave round primitives round") {
  const Scene scene = scene_of(
      "transform { scale 1 .5 1 } transform { scale 1 2 1 } sphere { center 0 1 0 radius .1 } "
      "transform_pop transform_pop");
  CHECK(shape_of<Sphere>(scene).center == Eigen::Vector3d(0, 1, 0));
  CHECK(shape_of<Sphere>(scene).radius == .1);
}

}  // namespace aspect
