#include "compiler/scene/bob_writer.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

#include "compiler/render/renderer.h"
#include "compiler/scene/bob_reader.h"
#include "compiler/scene/scene_reader.h"
#include "tests/compiler/scene/mesh_samples.h"
#include "tests/compiler/scene/scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

class RandomScene {
 public:
  explicit RandomScene(std::uint32_t seed) : engine_(seed) {}

  Scene make() {
    Scene scene;
    scene.studio.up = point();
    scene.studio.angle_deg = number(20, 90);
    scene.studio.width_px = 120, scene.studio.height_px = 90;
    scene.studio.aspect = number(.5, 2);
    scene.studio.ambient = colour(), scene.studio.background = colour();
    for (int k = whole(0, 2); k > 0; --k)
      scene.lights.push_back({3 * point(), colour(), whole(0, 1) == 0});
    for (int k = whole(1, 3); k > 0; --k) scene.surfaces.push_back({colour(), colour()});
    for (int k = whole(1, 8); k > 0; --k)
      scene.primitives.push_back({shape(), whole(0, static_cast<int>(scene.surfaces.size()) - 1)});
    return scene;
  }
  double number(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  Vector3d point() { return {number(-.3, .3), number(-.3, .3), number(-.3, .3)}; }

 private:
  int whole(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(engine_);
  }
  Vector3d colour() { return {number(0, 1), number(0, 1), number(0, 1)}; }
  decltype(Primitive::shape) shape() {
    switch (whole(0, 4)) {
      case 0:
        return Sphere{point(), number(.01, .2)};
      case 1:
        return Ring{point(), point().normalized(), number(0, .05), number(.1, .2)};
      case 2:
        return Cone{point(), point(), number(0, .1), number(.01, .1)};
      case 3:
        return Mesh{{point(), point(), point(), point()}, {{0, 1, 2}, {0, 2, 3}}};
      default:
        return Polygon{{point(), point(), point()}};
    }
  }
  std::mt19937 engine_;
};

Scene read_back(const Scene& scene) {
  const Result<std::string> text = write_bob(scene);
  if (!text) FAIL(text.error());
  return scene_of(text.value());
}

struct SameNumbers {
  bool operator()(const Polygon& a, const Polygon& b) const { return a.vertices == b.vertices; }
  bool operator()(const Sphere& a, const Sphere& b) const {
    return a.center == b.center && a.radius == b.radius;
  }
  bool operator()(const Ring& a, const Ring& b) const {
    return a.center == b.center && (a.normal - b.normal).norm() < 1e-15 &&
           a.min_radius == b.min_radius && a.max_radius == b.max_radius;
  }
  bool operator()(const Cone& a, const Cone& b) const {
    return a.base == b.base && a.apex == b.apex && a.base_radius == b.base_radius &&
           a.apex_radius == b.apex_radius;
  }
  template <typename A, typename B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

// What write_bob() makes of meshes.
std::vector<Primitive> without_meshes(const Scene& scene) {
  std::vector<Primitive> primitives;
  for (const Primitive& primitive : scene.primitives) {
    const auto* mesh = std::get_if<Mesh>(&primitive.shape);
    if (mesh == nullptr) {
      primitives.push_back(primitive);
      continue;
    }
    for (const auto& [a, b, c] : mesh->triangles)
      primitives.push_back(
          {Polygon{{mesh->vertices[a], mesh->vertices[b], mesh->vertices[c]}}, primitive.surface});
  }
  return primitives;
}

}  // namespace

TEST_CASE("a random scene that is written and read is the same to the last digit") {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Scene scene = RandomScene(seed).make(), back = read_back(scene);
    INFO(seed);
    const std::vector<Primitive> expected = without_meshes(scene);
    REQUIRE(back.primitives.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      REQUIRE(std::visit(SameNumbers{}, back.primitives[k].shape, expected[k].shape));
      const Surface& one = back.surfaces.at(static_cast<std::size_t>(back.primitives[k].surface));
      const Surface& other = scene.surfaces.at(static_cast<std::size_t>(expected[k].surface));
      REQUIRE(one.diffuse == other.diffuse);
      REQUIRE(one.ambient == other.ambient);
    }
    REQUIRE(back.lights.size() == scene.lights.size());
    for (std::size_t k = 0; k < back.lights.size(); ++k) {
      REQUIRE(back.lights[k].position == scene.lights[k].position);
      REQUIRE(back.lights[k].color == scene.lights[k].color);
      REQUIRE(back.lights[k].casts_shadows == scene.lights[k].casts_shadows);
    }
    REQUIRE(back.studio.up == scene.studio.up);
    REQUIRE(back.studio.angle_deg == scene.studio.angle_deg);
    REQUIRE(back.studio.aspect == scene.studio.aspect);
    REQUIRE(back.studio.ambient == scene.studio.ambient);
    REQUIRE(back.studio.background == scene.studio.background);
  }
}

TEST_CASE("mirrors, glass, lamps of all kinds and the studio's settings are written too") {
  Scene scene;
  Surface glass{{.1, .2, .3}, {.3, .2, .1}, {.5, .4, .3}, {.6, .7, .8}, 1.5, 20, {.9, .8, .7}, .1};
  glass.antialias = glass.casts_shadow = false;
  scene.surfaces = {glass};
  scene.primitives.push_back({SmoothTriangle{{Vector3d{0, 0, 0}, {.1, 0, 0}, {0, .1, 0}},
                                             {Vector3d{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}}});
  scene.lights.resize(3);
  scene.lights[0] = {{1, 2, 3}, {.5, .5, .5}, false};
  scene.lights[0].falloff = 2;
  scene.lights[0].spot = Light::Spot{{.1, .2, .3}, 10, 30};
  scene.lights[1].type = Light::Type::kDirectional;
  scene.lights[1].direction = {0, 1, 0};
  scene.lights[2].type = Light::Type::kSpherical;
  scene.lights[2].position = {2, 2, 2};
  scene.lights[2].radius = .3;
  scene.lights[2].samples = 25;
  scene.studio.projection = Projection::kOrthogonal;
  scene.studio.width = 1.25;
  scene.studio.antialias = Antialias::kAdaptive;
  scene.studio.threshold = 7;
  scene.studio.samples = 9;
  scene.studio.jitter = true;
  scene.studio.depth = 6;
  scene.studio.haze = .25;
  scene.studio.aperture = .05;
  scene.studio.focal_length = .9;
  scene.studio.exponential_transparency = false;
  const Scene back = read_back(scene);
  const Surface& surface = back.surfaces.at(static_cast<std::size_t>(back.primitives[0].surface));
  CHECK(surface.specular == glass.specular);
  CHECK(surface.transparent == glass.transparent);
  CHECK(surface.ior == glass.ior);
  CHECK(surface.shine == glass.shine);
  CHECK(surface.shine_color == glass.shine_color);
  CHECK(surface.fuzz == glass.fuzz);
  CHECK_FALSE((surface.antialias || surface.casts_shadow));
  CHECK(std::get<SmoothTriangle>(back.primitives[0].shape).normals[1] == Vector3d(0, 1, 0));
  REQUIRE(back.lights.size() == 3);
  CHECK(back.lights[0].falloff == 2);
  REQUIRE(back.lights[0].spot);
  CHECK(back.lights[0].spot->at == scene.lights[0].spot->at);
  CHECK(back.lights[0].spot->max_angle_deg == 30);
  CHECK(back.lights[1].type == Light::Type::kDirectional);
  CHECK(back.lights[1].direction == scene.lights[1].direction);
  CHECK(back.lights[2].type == Light::Type::kSpherical);
  CHECK(back.lights[2].radius == .3);
  CHECK(back.lights[2].samples == 25);
  const Studio &was = scene.studio, &is = back.studio;
  CHECK(is.projection == was.projection);
  CHECK(is.width == was.width);
  CHECK(is.antialias == was.antialias);
  CHECK(is.threshold == was.threshold);
  CHECK(is.samples == was.samples);
  CHECK(is.jitter);
  CHECK(is.depth == was.depth);
  CHECK(is.haze == was.haze);
  CHECK(is.aperture == was.aperture);
  CHECK(is.focal_length == was.focal_length);
  CHECK_FALSE(is.exponential_transparency);
}

TEST_CASE("a scene with textures is refused in one line") {
  Scene scene;
  scene.surfaces.emplace_back().texture = std::make_shared<Texture>();
  const Result<std::string> text = write_bob(scene);
  REQUIRE_FALSE(text);
  CHECK_THAT(text.error(), Catch::Contains("textures"));
}

TEST_CASE("a random scene that is written and read gives the same pictures") {
  int foreground = 0;
  for (std::uint32_t seed = 500; seed < 530; ++seed) {
    RandomScene random(seed);
    const Scene scene = random.make(), back = read_back(scene);
    const Camera camera = camera_at(scene.studio, random.point().normalized());
    Picture one, other;
    std::move(Renderer::create(scene)).value().render(camera, one);
    std::move(Renderer::create(back)).value().render(camera, other);
    int different = 0;
    for (std::size_t k = 0; k < one.surface.size(); ++k) {
      foreground += one.surface[k] != 0;
      const bool silhouette = (one.surface[k] == 0) == (other.surface[k] == 0);
      int worst = 0;
      for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
        worst = std::max(worst, std::abs(one.rgb[c] - other.rgb[c]));
      if (!silhouette || worst > 1) ++different;
    }
    INFO(seed);
    REQUIRE(different <= 1);
  }
  CHECK(foreground > 10000);
}

TEST_CASE("a mesh file becomes a Bob scene with the same pictures") {
  const TemporaryFolder folder;
  const SampleFile file = cube_ply("ascii", false);
  const Scene scene = std::move(read_scene(folder.write(file.name, file.bytes))).value();
  const Scene back = read_back(scene);
  Picture one, other;
  const Camera camera = camera_at(scene.studio, Vector3d(1, 2, 3).normalized());
  std::move(Renderer::create(scene)).value().render(camera, one);
  std::move(Renderer::create(back)).value().render(camera, other);
  CHECK(one.rgb == other.rgb);
  CHECK(one.surface == other.surface);
}

TEST_CASE("triangles without area are left out, and too many are refused") {
  Scene scene;
  scene.surfaces.resize(1);
  scene.primitives = {
      {Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.5, 1e-12, 0}}, {{0, 1, 2}, {0, 1, 3}}}, 0}};
  CHECK(read_back(scene).primitives.size() == 1);
  auto& mesh = std::get<Mesh>(scene.primitives[0].shape);
  mesh.triangles.resize(65535, mesh.triangles[0]);
  mesh.triangles[1] = mesh.triangles[0];
  const Result<std::string> text = write_bob(scene);
  REQUIRE_FALSE(text.ok());
  CHECK(text.error().find("65535 polygons, a Bob scene has at most 65534") != std::string::npos);
}

}  // namespace aspect
