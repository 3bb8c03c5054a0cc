// Traces the pixels of one tile after the other: a packet of 16 rays each.
#pragma once

#include "compiler/render/camera.h"
#include "compiler/render/embree_scene.h"
#include "compiler/render/pixel_writer.h"
#include "compiler/render/shading.h"

namespace aspect {

class TileTracer {
 public:
  TileTracer(const EmbreeScene& scene, const Shading& shading, const Rgb& background,
             const Camera& camera);

  // The tile's part that lies in the picture, at most 4x4 pixels.
  void trace(const Box& tile, PixelWriter& writer);

 private:
  void aim(const Box& tile);
  void shade(const Box& tile, PacketHits& hits, std::array<Rgb, 16>& colors);

  const EmbreeScene& scene_;
  const Shading& shading_;
  const Rgb background_;
  const Camera& camera_;
  bool orthogonal_;
  Eigen::Vector3d right_object_, down_object_;  // from one pixel to the next at depth 1
  Eigen::Vector3d first_object_;                // from the camera to pixel (0, 0), likewise
  RTCRayHit16 packet_{};
  std::array<std::array<float, 16>, 3> offsets_;  // of a lane from its tile
};

}  // namespace aspect
