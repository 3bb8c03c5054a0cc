#include <catch2/catch.hpp>

#include "tests/compiler/scene/scene_samples.h"

namespace aspect {
namespace {

double radius_of(const std::string& text) {
  return shape_of<Sphere>(scene_of("sphere { center 0 0 0 radius " + text + " }")).radius;
}

}  // namespace

TEST_CASE("numbers are written as in C") {
  CHECK(vector_of(".5 -1e-3 +1.85") == Eigen::Vector3d(.5, -1e-3, 1.85));
  CHECK(vector_of("5. 1E2 007") == Eigen::Vector3d(5, 100, 7));
}

TEST_CASE("a sign that touches its digits and follows white space starts the next component") {
  CHECK(vector_of("-2.5 0 +1.85") == Eigen::Vector3d(-2.5, 0, 1.85));
  CHECK(vector_of("2 -1 3") == Eigen::Vector3d(2, -1, 3));
  CHECK(vector_of("2\n-1\t-3") == Eigen::Vector3d(2, -1, -3));
  CHECK(vector_of("2/**/-1 3") == Eigen::Vector3d(2, -1, 3));
  CHECK(vector_of("(2 -1 3)") == Eigen::Vector3d(2, -1, 3));
}

TEST_CASE("any other sign adds or subtracts") {
  CHECK(vector_of("2 - 1 3 4") == Eigen::Vector3d(1, 3, 4));
  CHECK(vector_of("2-1 3 4") == Eigen::Vector3d(1, 3, 4));
  CHECK(vector_of("2- 1 3 4+1") == Eigen::Vector3d(1, 3, 5));
  CHECK(vector_of("2 - -1 3 4") == Eigen::Vector3d(3, 3, 4));
}

TEST_CASE("where one number alone is wanted a touching sign subtracts") {
  CHECK(radius_of("2 -1") == 1);
  CHECK(radius_of("2 - 1") == 1);
}

TEST_CASE("a sign that touches a macro starts the next component as well") {
  const Scene scene = scene_of("#define X 5\nsphere { center 1 -X -X radius 1 }");
  CHECK(shape_of<Sphere>(scene).center == Eigen::Vector3d(1, -5, -5));
}

TEST_CASE("a sign between a number and a macro that touch subtracts") {
  const Scene scene = scene_of("#define X 5\nsphere { center 2-X X-2 X radius 1 }");
  CHECK(shape_of<Sphere>(scene).center == Eigen::Vector3d(-3, 3, 5));
}

TEST_CASE("a macro is set apart by white space on both sides") {
  const Scene scene = scene_of("#define M-1\n#define T *2\nsphere { center 2 M (3)T radius 1 }");
  CHECK(shape_of<Sphere>(scene).center == Eigen::Vector3d(4, -2, 6));
}

TEST_CASE("brackets and the precedence of products hold") {
  CHECK(radius_of("1 + 2 * 3") == 7);
  CHECK(radius_of("(1 + 2) * 3") == 9);
  CHECK(radius_of("12 / 2 / 3") == 2);
  CHECK(radius_of("-(1 - 3)") == 2);
  CHECK(radius_of("((((2))))") == 2);
}

TEST_CASE("functions work in degrees and are exact at right angles") {
  CHECK(vector_of("sin(90) cos(90) tan(45)").isApprox(Eigen::Vector3d(1, 0, 1), 1e-15));
  CHECK(vector_of("sin(-90) cos(180) sin(540)") == Eigen::Vector3d(-1, -1, 0));
  CHECK(vector_of("asin(1) acos(0) atan(1)").isApprox(Eigen::Vector3d(90, 90, 45), 1e-15));
  CHECK(vector_of("sqrt(16) pow(2 10) pow(2 -1)") == Eigen::Vector3d(4, 1024, .5));
}

TEST_CASE("vectors are added, scaled, crossed and dotted") {
  CHECK(vector_of("(1 2 3) + (1 0 0)") == Eigen::Vector3d(2, 2, 3));
  CHECK(vector_of("(1 2 3) - (1 0 0) * 2") == Eigen::Vector3d(-1, 2, 3));
  CHECK(vector_of("2 * (1 2 3)") == Eigen::Vector3d(2, 4, 6));
  CHECK(vector_of("(1 2 3) / 2") == Eigen::Vector3d(.5, 1, 1.5));
  CHECK(vector_of("-(1 2 3)") == Eigen::Vector3d(-1, -2, -3));
  CHECK(vector_of("(1 0 0) cross (0 1 0)") == Eigen::Vector3d(0, 0, 1));
  CHECK(vector_of("1 0 0 cross 0 1 0") == Eigen::Vector3d(0, 0, 1));
  CHECK(vector_of("((1 2 3) dot (1 1 1)) 0 0") == Eigen::Vector3d(6, 0, 0));
  CHECK(radius_of("(1 2 3 dot 1 1 1)") == 6);
}

TEST_CASE(
    "behind three bare numbers an operator belongs to the vector, or to the number it touches") {
  CHECK(vector_of("1 2 3 * 2") == Eigen::Vector3d(2, 4, 6));
  CHECK(vector_of("1 2 3*2") == Eigen::Vector3d(1, 2, 6));
  CHECK(vector_of("1 2 3 + 1 0 0 * 2") == Eigen::Vector3d(3, 2, 3));
  CHECK(vector_of("1 2 3 - 1 0 0") == Eigen::Vector3d(0, 2, 3));
}

TEST_CASE("a colour macro can be dimmed whether or not the operator touches its name") {
  for (const char* dimmed : {"RED * .5", "RED*.5", ".5*(RED)"}) {
    const Scene scene = scene_of(std::string("#define RED 1 .5 0\nsurface { diffuse ") + dimmed +
                                 " } sphere { center 0 0 0 radius .1 }");
    CHECK(scene.surfaces[0].diffuse == Eigen::Vector3d(.5, .25, 0));
  }
}

}  // namespace aspect
