#include "tools/eval/class_views.h"

#include <catch2/catch.hpp>

#include "compiler/index/sphere_map_writer.h"
#include "tools/eval/random_directions.h"

namespace aspect {
namespace {

// Patches of level 3 in classes by the octant of their centres; class 7 is left out.
ClassIndex octants() {
  ViewSphere sphere;
  SphereClasses classes;
  for (int level = 0; level < 3; ++level)
    for (const PatchId leaf : sphere.leaves()) sphere.split(leaf);
  classes.class_of.assign(sphere.patch_count(), kNoClass);
  for (const PatchId leaf : sphere.leaves()) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const VertexId corner : sphere.patch(leaf).corners) centre += sphere.position(corner);
    const int octant =
        (centre.x() > 0 ? 0 : 1) + (centre.y() > 0 ? 0 : 2) + (centre.z() > 0 ? 0 : 4);
    classes.class_of[static_cast<std::size_t>(leaf)] = octant == 7 ? kNoClass : octant;
  }
  ClassIndex index;
  index.classes.resize(7);
  for (std::size_t c = 0; c < 7; ++c)
    index.classes[c].view = {c & 1U ? -0.6F : 0.6F, c & 2U ? -0.6F : 0.6F, c & 4U ? -0.53F : 0.53F};
  index.sphere_map = SphereMap::decode(encode_sphere_map(sphere, classes, 7, 3), 7).value();
  return index;
}

TEST_CASE("Inside a class's patches it is the nearest one") {
  const Result<ClassViews> views = ClassViews::create(octants());
  REQUIRE(views.ok());
  for (const Eigen::Vector3d& d : random_directions(500, 5)) {
    // Away from the borders: a view of a neighbour may be nearer there.
    if (d.cwiseAbs().minCoeff() < 0.15) continue;
    const int octant = (d.x() > 0 ? 0 : 1) + (d.y() > 0 ? 0 : 2) + (d.z() > 0 ? 0 : 4);
    CHECK(views.value().at(d) == (octant == 7 ? kNoClass : octant));
    if (octant != 7) CHECK(views.value().nearest(d) == octant);
  }
}

TEST_CASE("Where no class is, the one with the nearest view is right") {
  const ClassIndex index = octants();
  const Result<ClassViews> views = ClassViews::create(index);
  REQUIRE(views.ok());
  const Eigen::Vector3d beside_x = Eigen::Vector3d(-0.2, -0.7, -0.7).normalized();
  CHECK(views.value().at(beside_x) == kNoClass);
  CHECK(views.value().nearest(beside_x) == 6);
  CHECK(views.value().nearest(Eigen::Vector3d(-0.7, -0.7, -0.2).normalized()) == 3);
}

TEST_CASE("A rotation joins the classes that it takes into each other") {
  const ClassIndex index = octants();
  const Result<ClassViews> views = ClassViews::create(index);
  REQUIRE(views.ok());
  const Eigen::Matrix3d half_turn = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  const std::vector<Eigen::Matrix3d> rotations{Eigen::Matrix3d::Identity(), half_turn};
  const ClassSymmetry symmetry(index, views.value(), rotations);
  for (int a = 0; a < 7; ++a)
    for (int b = 0; b < 7; ++b) {
      INFO(a << " " << b);
      // 4 goes to 7, which is no class: the nearest one takes its place, and only there.
      const bool is_beside_7 = a == 4 || b == 4;
      if (!is_beside_7) CHECK(symmetry.same(a, b) == (a == b || (a ^ b) == 3));
      CHECK(symmetry.same(a, b) == symmetry.same(b, a));
    }
  const ClassSymmetry none(index, views.value(), std::span(rotations).first(1));
  CHECK(none.same(3, 3));
  CHECK_FALSE(none.same(0, 3));
}

TEST_CASE("A map without classes is refused") {
  ClassIndex index = octants();
  index.sphere_map = {};
  const Result<ClassViews> empty = ClassViews::create(index);
  REQUIRE_FALSE(empty.ok());
  CHECK_THAT(empty.error(), Catch::Matchers::Contains("no class"));
}

}  // namespace
}  // namespace aspect
