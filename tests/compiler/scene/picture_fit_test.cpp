#include "compiler/scene/picture_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "tests/compiler/scene/scene_samples.h"

namespace aspect {

TEST_CASE("an object fits whose sphere touches the sides of the picture") {
  Studio studio;
  studio.angle_deg = 60;
  CHECK(fitting_radius(studio) == Approx(.5));
  studio.aspect = std::sqrt(3.0) * std::tan(30 * M_PI / 180);
  CHECK(fitting_radius(studio) == Approx(.5));
  studio.aspect = 2;
  CHECK(fitting_radius(studio) == Approx(std::sin(std::atan(.5 / std::sqrt(3.0)))));
}

TEST_CASE("an object that leaves the picture is a warning with a scale that fits") {
  const Scene scene = scene_of(
      "studio { angle 60 }\nsphere { center 0 0 0 radius .1 }\nsphere { center 0 .25 0 radius .5 "
      "}");
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0] ==
        "s.b:3: the object leaves the picture at distance 1: its radius is 0.75, 0.5 fits; scale "
        "the whole object by 0.666666");
  const Scene scaled = scene_of(
      "studio { angle 60 } transform { scale 0.666666 }\nsphere { center 0 .25 0 radius .5 } "
      "transform_pop");
  CHECK(scaled.warnings.empty());
}

TEST_CASE("an object out of sight of the camera's aim is told to move") {
  const Scene scene = scene_of("studio { at 0 0 3 } sphere { center 0 0 0 radius .1 }");
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0].find("centre it at the origin, set at 0 0 0") != std::string::npos);
}

TEST_CASE("the bounding radius is exact for every primitive") {
  CHECK(bounding_radius(scene_of("")) == 0);
  CHECK(bounding_radius(scene_of("sphere { center 0 0 3 radius 1 }")) == 4);
  CHECK(bounding_radius(scene_of("polygon { points 3 vertex 0 0 0 vertex 3 4 0 vertex 0 1 0 }")) ==
        5);
  CHECK(bounding_radius(scene_of("ring { center 0 0 4 normal 0 0 1 radius 3 }")) == 5);
  CHECK(bounding_radius(scene_of("ring { center 2 0 4 normal 0 0 1 radius 1 }")) == 5);
  CHECK(bounding_radius(scene_of("ring { center 3 0 0 normal 1 0 0 radius 4 }")) == 5);
  CHECK(bounding_radius(scene_of("cone { base 0 0 -1 apex 0 0 4 base_radius 1 apex_radius 3 }")) ==
        5);
}

TEST_CASE("a sampled rim never reaches past the bounding radius and nearly reaches it") {
  const Scene scene = scene_of("ring { center .3 .1 .2 normal 1 2 3 radius .4 }");
  const Ring& ring = shape_of<Ring>(scene);
  const Eigen::Vector3d side = ring.normal.unitOrthogonal();
  const Eigen::Vector3d other = ring.normal.cross(side);
  double farthest = 0;
  for (int i = 0; i < 3600; ++i) {
    const double angle = i * M_PI / 1800;
    const Eigen::Vector3d point =
        ring.center + ring.max_radius * (std::cos(angle) * side + std::sin(angle) * other);
    farthest = std::max(farthest, point.norm());
  }
  CHECK(farthest <= bounding_radius(scene) + 1e-12);
  CHECK(farthest == Approx(bounding_radius(scene)).epsilon(1e-6));
}

}  // namespace aspect
