// The least that can be done to trace a scene with Embree, to hold the renderer against: one
// geometry of triangles and the round shapes, packets of 16 rays, the primitive's id a pixel.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/render/camera.h"
#include "compiler/render/round_shapes.h"
#include "compiler/scene/scene.h"
#include "runtime/vision/frame.h"

namespace aspect {

class BareEmbree {
 public:
  // robust: with RTC_SCENE_FLAG_ROBUST, as the renderer needs it.
  BareEmbree(const Scene& scene, bool robust);
  ~BareEmbree();
  BareEmbree(const BareEmbree&) = delete;
  BareEmbree& operator=(const BareEmbree&) = delete;

  // The rays of a perspective view through these tiles of 4 x 4 pixels, which lie in the picture:
  // `ids` gets 16 a tile.
  void trace(const Camera& camera, std::span<const Box> tiles, std::vector<std::uint32_t>& ids);

 private:
  void add_triangles(const Scene& scene);
  template <typename Shape, typename Rounded>
  void add_round_shapes(const Scene& scene, std::vector<Rounded>& shapes);
  void add(RTCGeometry geometry);

  RTCDevice device_;
  RTCScene scene_;
  std::vector<RoundSphere> spheres_;
  std::vector<RoundRing> rings_;
  std::vector<RoundCone> cones_;
};

}  // namespace aspect
