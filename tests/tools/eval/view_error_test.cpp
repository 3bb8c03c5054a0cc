#include "tools/eval/view_error.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "tests/tools/eval/object_rotations.h"

namespace aspect {
namespace {

Scene scene_of(const std::string& text, const std::string& at = "0 0 0") {
  const Result<Scene> scene =
      parse_bob(fmt::format("studio {{ at {} ambient 1 1 1 }}\n{}", at, text), "object.b");
  INFO((scene.ok() ? "" : scene.error()));
  REQUIRE(scene.ok());
  return scene.value();
}

std::string colour(int k) {
  return fmt::format("surface {{ diffuse {} .5 .2 }}\n", 0.1 * (k + 1));
}

// A block with faces of the colours given, in the order x, y, z and there plus and minus.
std::string block(double x, double y, double z, const std::array<int, 6>& colours) {
  const std::array<double, 3> half{x, y, z};
  std::string text;
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    text += colour(colours[face]) + "polygon { points 4";
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      std::array<double, 3> corner{};
      corner[axis] = face % 2 == 0 ? half[axis] : -half[axis];
      corner[u] = a * half[u];
      corner[v] = b * half[v];
      text += fmt::format(" vertex {}", fmt::join(corner, " "));
    }
    text += " }\n";
  }
  return text;
}

std::string prism(int sides) {
  std::string top, bottom, faces;
  const auto corner = [&](int k, double z) {
    const double angle = 2 * std::numbers::pi * k / sides;
    return fmt::format(" vertex {:.6f} {:.6f} {}", std::cos(angle), std::sin(angle), z);
  };
  for (int k = 0; k < sides; ++k) {
    top += corner(k, .3);
    bottom += corner(k, -.3);
    faces += fmt::format("polygon {{ points 4 {} {} {} {} }}\n", corner(k, .3), corner(k + 1, .3),
                         corner(k + 1, -.3), corner(k, -.3));
  }
  return fmt::format("{}polygon {{ points {} {} }}\npolygon {{ points {} {} }}\n{}{}", colour(0),
                     sides, top, sides, bottom, colour(1), faces);
}

std::size_t count_rotations(const std::string& text) {
  return object_rotations(scene_of(text)).size();
}

TEST_CASE("Colours and proportions decide which of the cube's rotations are left") {
  CHECK(count_rotations(block(1, 1, 1, {0, 0, 0, 0, 0, 0})) == 24);
  CHECK(count_rotations(block(1, 1, 1, {0, 1, 2, 3, 4, 5})) == 1);
  CHECK(count_rotations(block(1, 1, 1, {0, 0, 1, 1, 2, 2})) == 4);
  CHECK(count_rotations(block(1, 1, 1, {0, 1, 0, 1, 0, 1})) == 3);
  CHECK(count_rotations(block(1, 1, 2, {0, 0, 0, 0, 0, 0})) == 8);
  CHECK(count_rotations(block(1, 2, 3, {0, 0, 0, 0, 0, 0})) == 4);
  CHECK(count_rotations(block(1, 2, 3, {0, 0, 0, 0, 1, 2})) == 2);
}

TEST_CASE("Prisms have the turns of their bases, and half turns that swap them") {
  CHECK(count_rotations(prism(5)) == 10);
  CHECK(count_rotations(prism(6)) == 12);
  CHECK(count_rotations(prism(8)) == 16);
}

TEST_CASE("Round objects have a turn by any angle") {
  const std::string cone =
      colour(0) + "cone { base 0 0 0 base_radius 1 apex 0 1 0 apex_radius .5 }";
  CHECK(count_rotations(cone) == 360);
  CHECK(count_rotations(cone + "\nring { center 0 1 0 normal 0 -1 0 max_radius .5 }") == 360);
  CHECK(count_rotations(cone + "\nring { center .1 1 0 normal 0 1 0 max_radius .4 }") == 1);
  // A cylinder can also be turned over.
  CHECK(count_rotations(colour(0) + "cone { base 0 -1 0 apex 0 1 0 radius 1 }") == 720);
  CHECK(count_rotations(colour(0) + "sphere { center 0 0 0 radius 1 }") > 1000);
}

TEST_CASE("Smooth triangles turn with their normals, and textures with nothing") {
  const auto two_patches = [](const std::string& normal) {
    return "surface { diffuse 1 0 0 }\n"
           "patch { vertex 0 0 0 normal 0 0 1 vertex 1 0 0 normal 0 0 1 vertex 0 1 0 normal 0 0 1 }"
           "patch { vertex 0 0 0 normal " +
           normal +
           " vertex -1 0 0 normal 0 0 1 vertex 0 -1 0 "
           "normal 0 0 1 }";
  };
  CHECK(count_rotations(two_patches("0 0 1")) == 2);
  CHECK(count_rotations(two_patches("0 1 1")) == 1);
  CHECK(count_rotations("surface { texture { checker } } sphere { center 0 0 0 radius 1 }") == 1);
}

TEST_CASE("Rotations are about the point that the camera looks at") {
  const std::string text = block(1, 1, 1, {0, 0, 0, 0, 0, 0});
  CHECK(object_rotations(scene_of(text, "0 0 0.5")).size() == 4);
  CHECK(object_rotations(scene_of(text, "0.1 0.2 0.5")).size() == 1);
}

TEST_CASE("The index's symmetries are those that the scene's primitives have") {
  for (const char* name : {"cube", "blockcyl1", "dumbbell", "l_shape"}) {
    CAPTURE(name);
    Scene scene = read_bob(fmt::format(ASPECT_SOURCE_DIR "/compiler/models/{}.b", name)).value();
    const std::vector<Eigen::Matrix3d> right = object_rotations(scene);
    scene.studio.width_px = scene.studio.height_px = 192;
    CompileOptions options;
    options.level = options.min_level = 2;
    const auto bytes = compile(scene, options, {}, {}, nullptr).value().bytes;
    const ClassIndex index = parse_index(std::as_bytes(std::span(bytes)), name).value();
    const std::vector<Eigen::Matrix3d> found = index_rotations(index);
    REQUIRE(found.size() == right.size());
    for (const Eigen::Matrix3d& rotation : right)
      CHECK(std::any_of(found.begin(), found.end(),
                        [&](const auto& other) { return other.isApprox(rotation, 1e-4); }));
  }
}

TEST_CASE("BLOCKCYL1 has the half turn about its peg") {
  const Result<Scene> scene = read_bob(ASPECT_SOURCE_DIR "/compiler/models/blockcyl1.b");
  REQUIRE(scene.ok());
  const auto rotations = object_rotations(scene.value());
  REQUIRE(rotations.size() == 2);
  CHECK(rotations[0].isIdentity());
  CHECK(rotations[1].trace() == Approx(-1));
}

TEST_CASE("A set of rotations is made of rotations, each once") {
  const auto rotations = object_rotations(scene_of(prism(6)));
  for (std::size_t a = 0; a < rotations.size(); ++a) {
    CHECK((rotations[a] * rotations[a].transpose()).isIdentity(1e-12));
    CHECK(rotations[a].determinant() == Approx(1));
    for (std::size_t b = 0; b < a; ++b) CHECK_FALSE(rotations[a].isApprox(rotations[b], 1e-3));
  }
}

TEST_CASE("The error of a view is the least over the rotations") {
  const auto rotations = object_rotations(scene_of(prism(5)));
  const Eigen::Vector3d view = Eigen::Vector3d(1, 2, 3).normalized();
  for (const Eigen::Matrix3d& rotation : rotations)
    CHECK(view_error_rad(rotations, view, rotation * view) < 1e-7);
  CHECK(view_error_rad({rotations.front()}, view, -view) == Approx(std::numbers::pi));
  CHECK(view_error_rad(rotations, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()) ==
        Approx(std::numbers::pi / 2));
}

}  // namespace
}  // namespace aspect
