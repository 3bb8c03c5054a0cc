#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <string>

#include "tests/compiler/scene/scene_samples.h"

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

TEST_CASE("a studio says how a picture is taken") {
  const Studio studio = scene_of(
                            "studio { antialias adaptive threshold 3 samples 4 jitter depth 5 "
                            "no_exp_trans haze .1 aperture .2 focal_length 1.5 }")
                            .studio;
  CHECK(studio.antialias == Antialias::kAdaptive);
  CHECK(studio.threshold == 3);
  CHECK(studio.samples == 4);
  CHECK(studio.jitter);
  CHECK(studio.depth == 5);
  CHECK_FALSE(studio.exponential_transparency);
  CHECK(studio.haze == .1);
  CHECK(studio.aperture == .2);
  CHECK(studio.focal_length == 1.5);
  CHECK(scene_of("studio { antialias quick }").studio.antialias == Antialias::kQuick);
  CHECK(scene_of("studio { antialias corners }").studio.antialias == Antialias::kCorners);
  const Studio plain = scene_of("studio { antialias none project perspective }").studio;
  CHECK(plain.antialias == Antialias::kNone);
  CHECK(plain.projection == Projection::kPerspective);
  CHECK(plain.depth == 20);
  CHECK(plain.exponential_transparency);
}

TEST_CASE("a parallel projection has the width it names, or what the angle shows") {
  for (const char* text :
       {"studio { project flat .7 }", "studio { project orthogonal (.5 + .2) }"}) {
    const Studio studio = scene_of(text).studio;
    CHECK(studio.projection == Projection::kOrthogonal);
    CHECK(studio.width == Approx(.7));
  }
  const Studio studio = scene_of("studio { project orthogonal angle 90 }").studio;
  CHECK(studio.projection == Projection::kOrthogonal);
  CHECK(studio.width == Approx(2));
}

TEST_CASE("the last studio holds, with a warning") {
  const Scene scene = scene_of("studio { angle 30 }\nstudio { up 0 1 0 }");
  CHECK(scene.studio.angle_deg == 45);
  CHECK(scene.studio.up == Eigen::Vector3d(0, 1, 0));
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0] == "s.b:2: a second studio, the one at s.b:1 no longer holds; write one");
}

TEST_CASE("caustics are accepted with a warning") {
  const Scene scene = scene_of("studio { caustics }");
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0] == "s.b:1: caustics has no effect; leave it out");
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

TEST_CASE("lights of every type turn, move and shrink with their transform") {
  const Scene scene = scene_of(
      "transform { rotate 0 0 90 translate 1 0 0 scale .5 }"
      "light { type directional direction 3 0 0 color .1 .2 .3 }"
      "light { type spherical center 1 0 0 radius .4 samples 9 falloff 2 }"
      "light { position 1 0 0 at 2 0 0 min_angle 10 max_angle 20 falloff 1 } transform_pop");
  REQUIRE(scene.lights.size() == 3);
  const Light& sun = scene.lights[0];
  CHECK(sun.type == Light::Type::kDirectional);
  CHECK(sun.direction.isApprox(Eigen::Vector3d(0, 1, 0)));
  CHECK(sun.color == Eigen::Vector3d(.1, .2, .3));
  const Light& ball = scene.lights[1];
  CHECK(ball.type == Light::Type::kSpherical);
  CHECK(ball.position == Eigen::Vector3d(.5, .5, 0));
  CHECK(ball.radius == Approx(.2));
  CHECK(ball.samples == 9);
  CHECK(ball.falloff == 2);
  CHECK_FALSE(ball.spot.has_value());
  const Light& spot = scene.lights[2];
  CHECK(spot.type == Light::Type::kPoint);
  CHECK(spot.falloff == 1);
  REQUIRE(spot.spot.has_value());
  CHECK(spot.spot->at == Eigen::Vector3d(.5, 1, 0));
  CHECK(spot.spot->min_angle_deg == 10);
  CHECK(spot.spot->max_angle_deg == 20);
}

TEST_CASE("a surface has all its properties, and plain ones where it names none") {
  const std::string ball = kBall;
  const Scene scene = scene_of(
      "surface { diffuse 0 0 0 specular .1 .2 .3 transparent .4 .5 .6 ior 1.5 shine 20 .7 .8 .9 "
      "fuzz .05 no_antialias no_shadow }" +
      ball + "surface { }" + ball);
  const Surface& rich = scene.surfaces.at(0);
  CHECK(rich.specular == Eigen::Vector3d(.1, .2, .3));
  CHECK(rich.transparent == Eigen::Vector3d(.4, .5, .6));
  CHECK(rich.ior == 1.5);
  CHECK(rich.shine == 20);
  CHECK(rich.shine_color == Eigen::Vector3d(.7, .8, .9));
  CHECK(rich.fuzz == .05);
  CHECK_FALSE(rich.antialias);
  CHECK_FALSE(rich.casts_shadow);
  CHECK(rich.texture == nullptr);
  const Surface& plain = scene.surfaces.at(1);
  CHECK(plain.specular.isZero(0));
  CHECK(plain.transparent.isZero(0));
  CHECK(plain.ior == 1);
  CHECK(plain.shine == 0);
  CHECK(plain.antialias);
  CHECK(plain.casts_shadow);
  CHECK(scene.warnings.empty());
}

TEST_CASE("a highlight without a colour has the mirror's, or is white") {
  const std::string ball = kBall;
  const Scene scene =
      scene_of("surface { shine 5 specular .1 .2 .3 }" + ball + "surface { shine 2 * 3 }" + ball +
               "surface { shine 2 -1 0 0 }" + ball);
  CHECK(scene.surfaces.at(0).shine_color == Eigen::Vector3d(.1, .2, .3));
  CHECK(scene.surfaces.at(1).shine == 6);
  CHECK(scene.surfaces.at(1).shine_color == Eigen::Vector3d(1, 1, 1));
  CHECK(scene.surfaces.at(2).shine == 2);
  CHECK(scene.surfaces.at(2).shine_color == Eigen::Vector3d(-1, 0, 0));
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0] == "s.b:1: shine -1 0 0 is out of 0..1; write parts of 1");
}

TEST_CASE("a patch is placed with its normals at right angles to what was scaled") {
  const Scene scene = scene_of(
      "transform { scale 1 .5 1 } patch { vertex 0 0 0 normal 0 1 1 vertex .2 0 0 normal 0 0 2 "
      "vertex 0 .2 0 normal 1 0 1 } transform_pop");
  const SmoothTriangle& patch = shape_of<SmoothTriangle>(scene);
  CHECK(patch.vertices[2] == Eigen::Vector3d(0, .1, 0));
  CHECK(patch.normals[0].isApprox(Eigen::Vector3d(0, 2, 1).normalized()));
  CHECK(patch.normals[1] == Eigen::Vector3d(0, 0, 1));
  CHECK(bounding_radius(scene) == .2);
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
