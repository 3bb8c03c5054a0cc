// The colours of rays in scenes with mirrors, glass, highlights, textures, haze or lights other
// than points: Whitted's recursion (CACM 23(6), 1980) with the rules of Vivid and Bob. Slow next to
// Shading, which knows matte surfaces and point lights alone.
//
// A surface's colour is the sum of
//   studio.ambient * ambient * texture;
//   for each light that reaches it on the side that the ray comes from:
//     light * diffuse * texture * cos(normal, light) + light * shine_color * cos(mirrored ray,
//     light) ^ shine (Phong's highlight; none inside glass);
//   specular * the colour of the mirrored ray;
//   transparent * the colour of the refracted ray: the first transparent surface on a ray's way
//     leads into its substance, the next one out of it. There light fades by transparent ^ length;
//     with no_exp_trans, and for a part of `transparent` that is 0 or 1, by transparent at once.
// Outside of glass, haze h mixes in 1 - (1 - h) ^ length of the background. Shadows let light
// through glass straight on, faded likewise. fuzz adds a vector in a ball of that radius to the
// normal of mirrors, glass and highlights.
#pragma once

#include <Eigen/Core>

#include "compiler/render/camera.h"
#include "compiler/render/embree_scene.h"
#include "compiler/render/light_samples.h"
#include "compiler/render/sampling.h"
#include "compiler/scene/scene.h"

namespace aspect {

// Whether Shading and the tile map cannot draw the scene.
bool needs_single_rays(const Scene& scene);

// Immutable once made; any number of threads may use it.
class RayShading {
 public:
  explicit RayShading(const Scene& scene);

  const Studio& studio() const { return scene_.studio; }

  // What is seen along a ray, linear and not cut off. `key` must differ from ray to ray of a
  // picture.
  Eigen::Vector3d color(const EmbreeScene& embree, const ViewRay& ray, const SampleKey& key) const;

 private:
  struct Path;
  struct SurfacePoint;

  Eigen::Vector3d trace(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                        const Path& path) const;
  SurfacePoint point_of(const EmbreeScene::Hit& hit, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction, const Path& path) const;
  Eigen::Vector3d lit(const SurfacePoint& point, const Path& path) const;
  Eigen::Vector3d light_through(const SurfacePoint& point, const LightSample& light,
                                const Path& path) const;
  Eigen::Vector3d mirrored(const SurfacePoint& point, const Path& path) const;
  Eigen::Vector3d refracted(const SurfacePoint& point, const Path& path) const;
  Eigen::Vector3d fading(const Eigen::Vector3d& transparent, double length) const;

  Scene scene_;
  bool shadows_are_plain_ = true;  // whatever is in a light's way blocks it
};

}  // namespace aspect
