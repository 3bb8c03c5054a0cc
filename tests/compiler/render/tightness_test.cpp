// No ray may slip through where two surfaces meet.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/compiler/render/test_scenes.h"

using namespace aspect;

namespace {

// The silhouette of a convex body is convex: between the first and the last pixel of a row that
// show it, and of a column, none may show the background.
int holes_in_convex_picture(const Picture& picture) {
  int holes = 0;
  for (int y = 0; y < picture.height_px; ++y) {
    const std::uint16_t* row = &picture.surface[static_cast<std::size_t>(y * picture.width_px)];
    int first = 0, end = picture.width_px;
    while (first < end && row[first] == 0) ++first;
    while (end > first && row[end - 1] == 0) --end;
    for (int x = first; x < end; ++x) holes += row[x] == 0 ? 1 : 0;
  }
  return holes;
}

void require_tight(const Scene& scene, std::uint32_t seed, int views) {
  Random random(seed);
  const Renderer renderer = renderer_of(scene);
  Picture picture;
  for (int view = 0; view < views; ++view) {
    renderer.render(camera_at(scene.studio, random.direction()), picture);
    INFO("view " << view);
    REQUIRE_FALSE(picture.foreground.empty());
    REQUIRE(holes_in_convex_picture(picture) == 0);
  }
}

}  // namespace

TEST_CASE("a closed box lets no ray through") {
  require_tight(box_scene(512), 21, 200);
}

TEST_CASE("a closed cone of three surfaces lets no ray through") {
  require_tight(closed_cylinder_scene(512), 22, 200);
}

TEST_CASE("a body of 2048 facets lets no ray through") {
  require_tight(faceted_sphere_scene(512, 4), 23, 200);
}

TEST_CASE("rays straight through the edges and corners of a box do not slip through") {
  // Mirror images about the middle of the picture: with an odd size, the middle pixel's ray meets
  // the edges and corners that lie on the axes exactly.
  Scene scene = empty_scene(65, 65);
  add_box(scene, {-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25});
  const Renderer renderer = renderer_of(scene);
  Picture picture;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Eigen::Vector3d direction = Eigen::Vector3d(x, y, z).normalized();
        renderer.render(camera_at(scene.studio, direction), picture);
        REQUIRE(holes_in_convex_picture(picture) == 0);
        REQUIRE(picture.surface[32 * 65 + 32] != 0);
        REQUIRE(double{picture.depth[32 * 65 + 32]} < 0.76);
      }
}

TEST_CASE("rays along the rim at which two cones meet do not slip through") {
  // The rim lies in the plane y = 0, and so do the camera and its middle row of pixels.
  Scene scene = empty_scene(129, 129);
  scene.studio.up = {0, 1, 0};
  Random random(24);
  Picture picture;
  for (int k = 0; k < 50; ++k) {
    const double radius = random.uniform(0.1, 0.3);
    const Eigen::Vector3d rim(0, 0, 0), top(0, random.uniform(0.05, 0.3), 0);
    const Eigen::Vector3d bottom(0, -random.uniform(0.05, 0.3), 0);
    scene.primitives.clear();
    add_shape(scene, Cone{bottom, rim, random.uniform(0.05, 0.3), radius});
    add_shape(scene, Cone{rim, top, radius, random.uniform(0.05, 0.3)});
    const Renderer renderer = renderer_of(scene);
    for (int view = 0; view < 50; ++view) {
      const double angle = random.uniform(0, 7);
      renderer.render(camera_at(scene.studio, {std::cos(angle), 0, std::sin(angle)}), picture);
      for (std::size_t x = 50; x < 79; ++x) REQUIRE(picture.depth[64 * 129 + x] < 1);
    }
  }
}

TEST_CASE("rays along the rim at which a cone meets a disc do not slip through") {
  Scene scene = empty_scene(129, 129);
  scene.studio.up = {0, 1, 0};
  Random random(25);
  Picture picture;
  for (int k = 0; k < 200; ++k) {
    // The camera's middle ray meets the rim's nearest point.
    const double radius = random.uniform(0.1, 0.3);
    scene.primitives.clear();
    add_shape(scene, Cone{{0, -0.3, 0}, {0, 0, 0}, radius, radius});
    add_shape(scene, Ring{{0, 0, 0}, {0, 1, 0}, 0, radius});
    const double angle = random.uniform(0, 7), rise = random.uniform(0.05, 1);
    const Eigen::Vector3d outwards(std::cos(angle), 0, std::sin(angle));
    scene.studio.at = radius * outwards;
    const Eigen::Vector3d direction = (outwards + Eigen::Vector3d(0, rise, 0)).normalized();
    renderer_of(scene).render(camera_at(scene.studio, direction), picture);
    REQUIRE(double{picture.depth[64 * 129 + 64]} < 1.001);
  }
}
