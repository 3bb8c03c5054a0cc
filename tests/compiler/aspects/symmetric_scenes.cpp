#include "tests/compiler/aspects/symmetric_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aspect {
namespace {

Scene empty_scene(const char* name) {
  Scene scene;
  scene.name = scene.source = name;
  scene.studio.ambient = {1, 1, 1};
  scene.studio.width_px = scene.studio.height_px = 192;
  scene.studio.up = {0.1, 0.05, 1};
  for (int colour = 0; colour < 8; ++colour)
    scene.surfaces.push_back({test_colour(colour), test_colour(colour)});
  return scene;
}

Eigen::Vector3d face_normal(std::size_t face) {
  return (face % 2 == 0 ? 1 : -1) * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(face / 2));
}

struct Turn {
  const Eigen::Quaterniond& rotation;
  void operator()(Polygon& polygon) const {
    for (Eigen::Vector3d& vertex : polygon.vertices) vertex = rotation * vertex;
  }
  void operator()(Mesh& mesh) const {
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex = rotation * vertex;
  }
  void operator()(SmoothTriangle& triangle) const {
    for (Eigen::Vector3d& vertex : triangle.vertices) vertex = rotation * vertex;
    for (Eigen::Vector3d& normal : triangle.normals) normal = rotation * normal;
  }
  void operator()(Sphere& sphere) const { sphere.center = rotation * sphere.center; }
  void operator()(Ring& ring) const {
    ring.center = rotation * ring.center;
    ring.normal = rotation * ring.normal;
  }
  void operator()(Cone& cone) const {
    cone.base = rotation * cone.base;
    cone.apex = rotation * cone.apex;
  }
};

}  // namespace

Eigen::Vector3d test_colour(int colour) {
  const std::array<Eigen::Vector3d, 8> colours = {Eigen::Vector3d(.85, .1, .1),
                                                  {.1, .75, .15},
                                                  {.12, .2, .85},
                                                  {.9, .85, .08},
                                                  {.05, .8, .8},
                                                  {.8, .1, .75},
                                                  {.95, .45, .05},
                                                  {.6, .6, .6}};
  return colours.at(static_cast<std::size_t>(colour));
}

Scene block_scene(const Eigen::Vector3d& half, const std::array<int, 6>& colours) {
  Scene scene = empty_scene("block");
  for (std::size_t face = 0; face < 6; ++face) {
    const auto axis = static_cast<Eigen::Index>(face / 2);
    const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
    Polygon polygon;
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      Eigen::Vector3d corner;
      corner[axis] = face % 2 == 0 ? half[axis] : -half[axis];
      corner[u] = a * half[u];
      corner[v] = b * half[v];
      polygon.vertices.push_back(corner);
    }
    scene.primitives.push_back({polygon, colours[face]});
  }
  return scene;
}

Scene prism_scene(const std::vector<int>& sides, int top, int bottom) {
  constexpr double kRadius = 0.25, kHalfHeight = 0.12;
  Scene scene = empty_scene("prism");
  const std::size_t count = sides.size();
  const auto corner = [&](std::size_t k, double z) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(k % count) / static_cast<double>(count);
    return Eigen::Vector3d(kRadius * std::cos(angle), kRadius * std::sin(angle), z);
  };
  Polygon upper, lower;
  for (std::size_t k = 0; k < count; ++k) {
    upper.vertices.push_back(corner(k, kHalfHeight));
    lower.vertices.push_back(corner(k, -kHalfHeight));
    scene.primitives.push_back({Polygon{{corner(k, kHalfHeight), corner(k + 1, kHalfHeight),
                                         corner(k + 1, -kHalfHeight), corner(k, -kHalfHeight)}},
                                sides[k]});
  }
  scene.primitives.push_back({upper, top});
  scene.primitives.push_back({lower, bottom});
  return scene;
}

void add_cylinder(Scene& scene, double from_z, double to_z, double radius, int side, int end) {
  const Eigen::Vector3d base(0, 0, from_z), apex(0, 0, to_z), up(0, 0, 1);
  scene.primitives.push_back({Cone{base, apex, radius, radius}, side});
  scene.primitives.push_back({Ring{base, up, 0, radius}, end});
  scene.primitives.push_back({Ring{apex, up, 0, radius}, end});
}

void rotate(Scene& scene, const Eigen::Quaterniond& rotation) {
  for (Primitive& primitive : scene.primitives) std::visit(Turn{rotation}, primitive.shape);
}

std::vector<Eigen::Quaterniond> colour_rotations(const std::array<int, 6>& colours) {
  std::vector<Eigen::Quaterniond> kept;
  std::array<Eigen::Index, 3> axes = {0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
      for (unsigned k = 0; k < 3; ++k) matrix(k, axes[k]) = (signs >> k & 1U) == 0 ? 1 : -1;
      if (matrix.determinant() < 0 || matrix.isIdentity()) continue;
      bool keeps = true;
      for (std::size_t from = 0; from < 6; ++from)
        for (std::size_t to = 0; to < 6; ++to)
          if (matrix * face_normal(from) == face_normal(to) && colours[from] != colours[to])
            keeps = false;
      if (keeps) kept.emplace_back(matrix);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return kept;
}

}  // namespace aspect
