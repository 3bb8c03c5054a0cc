// Scenes made by hand, and seeded random directions.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"

namespace aspect {

// A studio with ambient light 1 and a camera of 50 degrees, and one white surface.
Scene empty_scene(int width_px, int height_px);

// Adds a primitive with a surface of its own, coloured by its number.
void add_shape(Scene& scene, const decltype(Primitive::shape)& shape);

// Six polygons.
void add_box(Scene& scene, const Eigen::Vector3d& least, const Eigen::Vector3d& greatest);

Scene box_scene(int size_px);
Scene closed_cylinder_scene(int size_px);

// An octahedron whose faces are split `splits` times into four, pushed out to a sphere.
Scene faceted_sphere_scene(int size_px, int splits);

Renderer renderer_of(const Scene& scene);

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double uniform(double least, double most);
  int whole(int least, int most);
  Eigen::Vector3d direction();          // unit length
  Eigen::Vector3d point(double reach);  // in a cube about the origin

 private:
  std::mt19937 engine_;
};

}  // namespace aspect
