#include "compiler/render/texture_color.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

using namespace aspect;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

void require_position(const decltype(Primitive::shape)& shape, const Vector3d& point,
                      const Vector2d& expected, const Texture& texture = {}) {
  const Vector2d found = map_position({shape, 0}, texture, point);
  INFO(found.transpose() << " instead of " << expected.transpose());
  REQUIRE((found - expected).norm() < 1e-9);
}

Texture tile_texture() {
  auto picture = std::make_shared<TextureMap>();
  picture->width_px = 2;
  picture->height_px = 2;
  picture->rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  Texture texture;
  texture.pattern = ImageMap{picture};
  return texture;
}

}  // namespace

TEST_CASE("u and v run over a polygon's rectangle from its first edge") {
  const Polygon slanted{{{0, 0, 1}, {2, 0, 1}, {3, 1, 1}, {1, 1, 1}}};
  require_position(slanted, {0, 0, 1}, {0, 0});
  require_position(slanted, {2, 0, 1}, {2 / 3.0, 0});
  require_position(slanted, {1.5, .5, 1}, {.5, .5});
  const Polygon back{{{0, 0, 1}, {0, 1, 1}, {2, 1, 1}, {2, 0, 1}}};
  require_position(back, {.5, .25, 1}, {.25, .25});
  const Polygon repeated{{{0, 0, 1}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}}};
  require_position(repeated, {.5, .5, 1}, {.25, .5});
}

TEST_CASE("u and v of a smooth triangle are the weights of two vertices") {
  const Vector3d up = Vector3d::UnitZ();
  const SmoothTriangle triangle{{{{1, 0, 0}, {3, 0, 0}, {1, 4, 1}}}, {{up, up, up}}};
  require_position(triangle, {1, 0, 0}, {0, 0});
  require_position(triangle, {3, 0, 0}, {1, 0});
  require_position(triangle, {1.5, 2, .5}, {.25, .5});
}

TEST_CASE("u is a sphere's longitude and v its latitude, by the axes of the frame") {
  const Sphere sphere{{1, 1, 1}, 2};
  require_position(sphere, {3, 1, 1}, {0, .5});
  require_position(sphere, {1, 3, 1}, {.25, .5});
  require_position(sphere, {1, -1, 1}, {.75, .5});
  require_position(sphere, {1 + std::sqrt(2.0), 1, 1 + std::sqrt(2.0)}, {0, .75});
  Texture turned;
  turned.frame_from_object = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ());
  require_position(sphere, {3, 1, 1}, {.25, .5}, turned);
}

TEST_CASE("u and v run over a ring's square and around a cone") {
  const Ring ring{{0, 0, 5}, {0, 0, 1}, .5, 2};
  require_position(ring, {0, 0, 5}, {.5, .5});
  require_position(ring, {2, -2, 5}, {1, 0});
  const Cone cone{{0, 0, 1}, {0, 0, 3}, 1, 1};
  require_position(cone, {1, 0, 1}, {0, 0});
  require_position(cone, {0, 1, 2}, {.25, .5});
  require_position(cone, {-1, 0, 3}, {.5, 1});
  const Cone along_x{{0, 0, 0}, {2, 0, 0}, 1, 1};
  require_position(along_x, {1, 1, 0}, {0, .5});
  require_position(along_x, {1, 0, 1}, {.25, .5});
}

TEST_CASE("a map's picture stands upright and repeats") {
  const Primitive square = {Polygon{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, 0};
  Texture texture = tile_texture();
  CHECK(texture_color(texture, square, {.2, .8, 0}) == Vector3d(1, 0, 0));
  CHECK(texture_color(texture, square, {.8, .8, 0}) == Vector3d(0, 1, 0));
  CHECK(texture_color(texture, square, {.2, .2, 0}) == Vector3d(0, 0, 1));
  CHECK(texture_color(texture, square, {.8, .2, 0}) == Vector3d(1, 1, 1));
  texture.pattern_from_frame = Eigen::Translation3d(.5, 7, 0) * Eigen::Scaling(3.0, 1.0, 1.0);
  CHECK(texture_color(texture, square, {.01, .8, 0}) == Vector3d(0, 1, 0));
  CHECK(texture_color(texture, square, {.2, .8, 0}) == Vector3d(1, 0, 0));
}

TEST_CASE("a face between two layers of a checker belongs to one of them all over") {
  Texture texture;
  texture.pattern = Checker{};
  const Primitive any = {Sphere{{0, 0, 0}, 1}, 0};
  for (const double noise : {-1e-7, 0.0, 1e-7}) {
    CHECK(texture_color(texture, any, {.5, .5, 2 + noise}) == Vector3d(1, 1, 1));
    CHECK(texture_color(texture, any, {-.5, .5, 2 + noise}) == Vector3d(0, 0, 0));
    CHECK(texture_color(texture, any, {.5, .5, 1 + noise}) == Vector3d(0, 0, 0));
  }
}
