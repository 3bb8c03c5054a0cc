// The nine models of the thesis: what its 4.1 says of their boundaries, and what Aspect needs.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/scene/bob_reader.h"
#include "tests/compiler/scene/scene_samples.h"

namespace aspect {
namespace {

struct Expected {
  const char* name;
  int polygons;
  int rings;
  int cones;
  double radius;
};

constexpr Expected kModels[] = {
    {"cube", 6, 0, 0, .36},           {"l_shape", 8, 0, 0, .36},   {"dumbbell", 0, 4, 3, .36},
    {"holeblock", 16, 0, 0, .36},     {"blockcyl1", 6, 1, 1, .36}, {"blockcyl2", 6, 1, 1, .36},
    {"blockcyl3", 6, 1, 1, .54},      {"pegblock", 6, 1, 1, .36},  {"truck", 65, 12, 6, .36},
    {"truck_unique", 65, 12, 6, .36},
};

// The least distance of two r:g:b ratios that segmentation is to tell apart.
constexpr double kSeparable = .1;

Scene model(const std::string& name) {
  const auto file =
      std::filesystem::path(ASPECT_SOURCE_DIR) / "compiler" / "models" / (name + ".b");
  Result<Scene> scene = read_bob(file);
  if (!scene.ok()) FAIL(scene.error());
  return std::move(scene).value();
}

template <typename Shape>
int count(const Scene& scene) {
  return static_cast<int>(std::count_if(
      scene.primitives.begin(), scene.primitives.end(),
      [](const Primitive& primitive) { return std::holds_alternative<Shape>(primitive.shape); }));
}

Eigen::Vector3d ratio(const Scene& scene, std::size_t primitive) {
  const auto surface = static_cast<std::size_t>(scene.primitives.at(primitive).surface);
  const Eigen::Vector3d& color = scene.surfaces.at(surface).diffuse;
  return color / color.sum();
}

bool alike(const Scene& scene, std::size_t a, std::size_t b) {
  return (ratio(scene, a) - ratio(scene, b)).norm() < .01;
}

bool separable(const Scene& scene, std::size_t a, std::size_t b) {
  return (ratio(scene, a) - ratio(scene, b)).norm() >= kSeparable;
}

using Edge = std::pair<std::array<double, 3>, std::array<double, 3>>;

std::array<double, 3> rounded(const Eigen::Vector3d& v) {
  const auto part = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };
  return {part(v.x()), part(v.y()), part(v.z())};
}

// How often each edge of the polygons occurs, whichever way round.
std::map<Edge, int> edge_counts(const Scene& scene) {
  std::map<Edge, int> counts;
  for (const Primitive& primitive : scene.primitives) {
    const auto* polygon = std::get_if<Polygon>(&primitive.shape);
    if (polygon == nullptr) continue;
    const auto& vertices = polygon->vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto from = rounded(vertices[i]);
      const auto to = rounded(vertices[(i + 1) % vertices.size()]);
      ++counts[{std::min(from, to), std::max(from, to)}];
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("every model has the thesis's primitives") {
  for (const Expected& expected : kModels) {
    INFO(expected.name);
    const Scene scene = model(expected.name);
    CHECK(scene.name == expected.name);
    CHECK(count<Polygon>(scene) == expected.polygons);
    CHECK(count<Ring>(scene) == expected.rings);
    CHECK(count<Cone>(scene) == expected.cones);
    CHECK(count<Sphere>(scene) == 0);
  }
}

TEST_CASE("every model lies in the picture, read without a warning") {
  for (const Expected& expected : kModels) {
    INFO(expected.name);
    const Scene scene = model(expected.name);
    CHECK(scene.warnings == std::vector<std::string>{});
    CHECK(bounding_radius(scene) == Approx(expected.radius).epsilon(.002));
  }
}

TEST_CASE("every model is seen through the thesis's studio") {
  for (const Expected& expected : kModels) {
    INFO(expected.name);
    const Studio studio = model(expected.name).studio;
    CHECK(studio.at == Eigen::Vector3d(0, 0, 0));
    CHECK(studio.up == Eigen::Vector3d(0, 1, .05));
    CHECK(studio.angle_deg == (std::string(expected.name) == "blockcyl3" ? 75 : 50));
    CHECK(studio.width_px == 512);
    CHECK(studio.height_px == 512);
    CHECK(studio.ambient == Eigen::Vector3d(1, 1, 1));
  }
}

TEST_CASE("every colour is bright enough and either alike or separable from every other") {
  for (const Expected& expected : kModels) {
    const Scene scene = model(expected.name);
    for (std::size_t a = 0; a < scene.primitives.size(); ++a) {
      const auto surface = static_cast<std::size_t>(scene.primitives[a].surface);
      CHECK(scene.surfaces[surface].diffuse.sum() >= .45);
      for (std::size_t b = 0; b < a; ++b) {
        INFO(expected.name << " primitives " << a << " and " << b);
        CHECK((alike(scene, a, b) || separable(scene, a, b)));
      }
    }
  }
}

TEST_CASE("the polygons of the angular models close: every edge has two") {
  for (const char* name : {"cube", "l_shape", "holeblock", "blockcyl1", "pegblock"}) {
    INFO(name);
    for (const auto& [edge, times] : edge_counts(model(name))) CHECK(times == 2);
  }
}

TEST_CASE("the cube has six colours") {
  const Scene scene = model("cube");
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < a; ++b) CHECK(separable(scene, a, b));
  }
}

TEST_CASE("the L_SHAPE has the thesis's vertices and alike faces") {
  const Scene scene = model("l_shape");
  const double scale = .35088 * .2432;
  const auto& front = shape_of<Polygon>(scene, 0).vertices;
  CHECK(front[0].isApprox(scale * Eigen::Vector3d(-2.5, 2.85, 1.85)));
  CHECK(front[2].isApprox(scale * Eigen::Vector3d(2.5, -2.85, 1.85)));
  const auto& back = shape_of<Polygon>(scene, 1).vertices;
  CHECK(back[0].isApprox(scale * Eigen::Vector3d(-.6, 2.85, -1.85)));
  CHECK(alike(scene, 0, 1));
  CHECK(alike(scene, 0, 6));
}

TEST_CASE("the BLOCKCYL1 has alike opposite faces and its cylinder like its small ends") {
  const Scene scene = model("blockcyl1");
  for (const std::size_t face : {0U, 2U, 4U}) CHECK(alike(scene, face, face + 1));
  CHECK(alike(scene, 0, 7 - 1));
  CHECK(separable(scene, 0, 2));
  CHECK(separable(scene, 2, 4));
}

TEST_CASE("the BLOCKCYL2 has a colour of its own for every surface, and BLOCKCYL3 is the same") {
  const Scene scene = model("blockcyl2");
  const Scene nearer = model("blockcyl3");
  REQUIRE(nearer.primitives.size() == scene.primitives.size());
  for (std::size_t a = 0; a < scene.primitives.size(); ++a) {
    CHECK(ratio(scene, a) == ratio(nearer, a));
    for (std::size_t b = 0; b < a; ++b) CHECK(separable(scene, a, b));
  }
  CHECK(bounding_radius(nearer) > bounding_radius(scene));
}

TEST_CASE("the PEGBLOCK's peg is like exactly one side of the block") {
  const Scene scene = model("pegblock");
  int like_peg = 0;
  for (std::size_t face = 0; face < 6; ++face) like_peg += alike(scene, face, 6) ? 1 : 0;
  CHECK(like_peg == 1);
}

TEST_CASE("the DUMBBELL's seven surfaces differ") {
  const Scene scene = model("dumbbell");
  for (std::size_t a = 0; a < 7; ++a) {
    for (std::size_t b = 0; b < a; ++b) CHECK(separable(scene, a, b));
  }
}

}  // namespace aspect
