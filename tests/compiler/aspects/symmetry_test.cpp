// Symmetries found from views, against groups known from the geometry.
#include "compiler/aspects/symmetry.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "compiler/aspects/rotation_group.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/compiler/aspects/symmetric_scenes.h"

namespace aspect {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180;

Symmetries symmetries_of(const Scene& scene, int level = 2) {
  const CompileOptions options = options_of_level(level);
  const Result<Renderer> renderer = Renderer::create(scene);
  REQUIRE(renderer.ok());
  const Workshop workshop{renderer.value(), scene.studio, options, nullptr, {}, nullptr};
  const Subdivision subdivision = subdivide(workshop).value();
  return find_symmetries(workshop, subdivision);
}

bool holds(const std::vector<Eigen::Quaterniond>& all, const Eigen::Quaterniond& one,
           double within_rad) {
  return std::any_of(all.begin(), all.end(), [&](const Eigen::Quaterniond& other) {
    return angle_between_rad(one, other) < within_rad;
  });
}

void check_same_rotations(const std::vector<Eigen::Quaterniond>& found,
                          const std::vector<Eigen::Quaterniond>& right, double within_rad = 1e-6) {
  CHECK(found.size() == right.size());
  for (const Eigen::Quaterniond& rotation : right) CHECK(holds(found, rotation, within_rad));
}

// Turns of n-fold prisms, with the half turns across if `both_ends`; `odd` turns them all.
std::vector<Eigen::Quaterniond> prism_rotations(int fold, bool both_ends) {
  std::vector<Eigen::Quaterniond> all;
  for (int k = 0; k < fold; ++k) {
    const double angle = 2 * std::numbers::pi * k / fold;
    if (k > 0) all.emplace_back(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    if (both_ends)
      all.emplace_back(Eigen::AngleAxisd(
          std::numbers::pi, Eigen::Vector3d(std::cos(angle / 2), std::sin(angle / 2), 0)));
  }
  return all;
}

const Eigen::Vector3d kCube(.2, .2, .2);

}  // namespace

TEST_CASE("cubes have the rotations that keep the colours of their faces") {
  for (const std::array<int, 6>& colours :
       {std::array{0, 1, 2, 3, 4, 5}, std::array{0, 0, 0, 0, 0, 0}, std::array{0, 0, 1, 1, 2, 2},
        std::array{0, 1, 0, 1, 0, 1}, std::array{0, 0, 1, 2, 3, 4}, std::array{0, 0, 1, 2, 1, 2}}) {
    CAPTURE(colours);
    check_same_rotations(symmetries_of(block_scene(kCube, colours)).rotations,
                         colour_rotations(colours));
  }
}

TEST_CASE("random cubes of two colours have exactly the rotations found by brute force") {
  std::mt19937 random(7);
  for (int round = 0; round < 12; ++round) {
    std::array<int, 6> colours{};
    for (int& colour : colours) colour = static_cast<int>(random() % 2);
    CAPTURE(colours);
    const Symmetries found = symmetries_of(block_scene(kCube, colours));
    check_same_rotations(found.rotations, colour_rotations(colours));
    CHECK(found.axes.empty());
  }
}

TEST_CASE("prisms have the turns of their base, and half turns where their ends are alike") {
  for (const std::size_t sides : {std::size_t{3}, std::size_t{5}, std::size_t{6}}) {
    CAPTURE(sides);
    std::vector<int> colours(sides, 2);
    check_same_rotations(symmetries_of(prism_scene(colours, 0, 1)).rotations,
                         prism_rotations(static_cast<int>(sides), false));
    check_same_rotations(symmetries_of(prism_scene(colours, 0, 0)).rotations,
                         prism_rotations(static_cast<int>(sides), true), 0.5 * kDegree_rad);
    colours[1] = 3;
    CHECK(symmetries_of(prism_scene(colours, 0, 1)).rotations.empty());
  }
}

TEST_CASE("an object that stands askew in its coordinates keeps its symmetries") {
  const Eigen::Quaterniond askew(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1.5).normalized()));
  Scene prism = prism_scene({2, 3, 2, 3, 2, 3}, 0, 1);
  rotate(prism, askew);
  std::vector<Eigen::Quaterniond> right;
  for (const Eigen::Quaterniond& rotation : prism_rotations(3, false))
    right.push_back(askew * rotation * askew.conjugate());
  check_same_rotations(symmetries_of(prism).rotations, right, 0.5 * kDegree_rad);

  Scene round = prism_scene({}, 0, 0);
  round.primitives.clear();
  add_cylinder(round, -.2, .1, .15, 1, 0);
  add_cylinder(round, .1, .2, .08, 2, 3);
  rotate(round, askew);
  const Symmetries found = symmetries_of(round);
  CHECK(found.rotations.empty());
  REQUIRE(found.axes.size() == 1);
  CHECK(found.axes[0].cross(askew * Eigen::Vector3d::UnitZ()).norm() < 0.5 * kDegree_rad);
}

TEST_CASE("round objects have an axis, and a half turn across it where their ends are alike") {
  Scene cylinder = prism_scene({}, 0, 0);
  cylinder.primitives.clear();
  add_cylinder(cylinder, -.2, .2, .15, 1, 0);
  const Symmetries found = symmetries_of(cylinder);
  REQUIRE(found.axes.size() == 1);
  CHECK(found.axes[0] == Eigen::Vector3d::UnitZ());
  REQUIRE(found.rotations.size() == 1);
  CHECK(found.rotations[0].w() == 0);
  CHECK(std::abs(found.rotations[0].z()) < 1e-12);

  cylinder.primitives.clear();
  cylinder.primitives.push_back({Sphere{{0, 0, 0}, .2}, 0});
  CHECK(symmetries_of(cylinder).axes.size() == 3);
}

TEST_CASE("a mirror image is no symmetry") {
  // The corner tetrahedron's colours: mirrored in x = y, but not turned.
  CHECK(symmetries_of(block_scene({.2, .2, .2}, {0, 1, 0, 1, 2, 3})).rotations.empty());
  CHECK(symmetries_of(block_scene({.1, .15, .2}, {0, 0, 1, 2, 3, 4})).rotations.empty());
}

TEST_CASE("the thesis's objects have the symmetries of their making") {
  const auto model = [](const char* name) { return symmetries_of(small_model_scene(name)); };
  for (const char* name : {"cube", "l_shape", "pegblock", "blockcyl2", "blockcyl3"}) {
    CAPTURE(name);
    CHECK(model(name).rotations.empty());
    CHECK(model(name).axes.empty());
  }
  const Symmetries dumbbell = model("dumbbell");
  CHECK(dumbbell.rotations.empty());
  REQUIRE(dumbbell.axes.size() == 1);
  CHECK(dumbbell.axes[0] == Eigen::Vector3d::UnitY());
  const Symmetries blockcyl = model("blockcyl1");
  REQUIRE(blockcyl.rotations.size() == 1);
  CHECK(angle_between_rad(blockcyl.rotations[0], Eigen::Quaterniond(0, 0, 0, 1)) < 1e-9);
}

TEST_CASE("symmetries cost few views and are the same for any number of threads") {
  const Symmetries none = symmetries_of(small_model_scene("cube"));
  CHECK(none.views_rendered == 0);
  const Symmetries all = symmetries_of(block_scene(kCube, {0, 0, 0, 0, 0, 0}));
  CHECK(all.views_rendered <= 400);
  const Symmetries again = symmetries_of(block_scene(kCube, {0, 0, 0, 0, 0, 0}));
  REQUIRE(again.rotations.size() == all.rotations.size());
  for (std::size_t k = 0; k < all.rotations.size(); ++k)
    CHECK(again.rotations[k].coeffs() == all.rotations[k].coeffs());
}

TEST_CASE("a group is closed, and one that never ends is refused") {
  RotationGroup group;
  CHECK(group.add(turn_of(Eigen::Vector3d::UnitZ(), 4)));
  CHECK(group.elements().size() == 4);
  CHECK(group.add(turn_of(Eigen::Vector3d::UnitX(), 4)));
  CHECK(group.elements().size() == 24);
  CHECK_FALSE(group.add(turn_of(Eigen::Vector3d(1, 2, 3).normalized(), 7)));
  CHECK(group.elements().size() == 24);
  CHECK(group.elements().front().isApprox(Eigen::Quaterniond::Identity()));
}

}  // namespace aspect
