#include "tests/compiler/viewsphere/sphere_samples.h"

namespace aspect {

ViewSphere uniform_sphere(int level) {
  ViewSphere sphere;
  for (int done = 0; done < level; ++done) {
    for (const PatchId leaf : sphere.leaves()) sphere.split(leaf);
  }
  return sphere;
}

ViewSphere random_sphere(std::uint32_t seed, int splits, int max_level) {
  std::mt19937 random(seed);
  ViewSphere sphere;
  Eigen::Vector3d spot = random_direction(random);
  for (int done = 0; done < splits; ++done) {
    const bool deep = done % 3 == 0;
    const PatchId leaf = sphere.locate(deep ? spot : random_direction(random));
    if (sphere.patch(leaf).level < max_level) {
      sphere.split(leaf);
    } else if (deep) {
      spot = random_direction(random);
    }
  }
  return sphere;
}

Eigen::Vector3d random_direction(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (;;) {
    const Eigen::Vector3d point(coordinate(random), coordinate(random), coordinate(random));
    if (point.norm() > 0.1 && point.norm() < 1) return point.normalized();
  }
}

}  // namespace aspect
