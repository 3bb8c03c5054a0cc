// Pictures of a scene: colour, surface id and depth of every pixel, by ray tracing with Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "compiler/render/camera.h"
#include "compiler/render/tile_map.h"
#include "compiler/scene/scene.h"
#include "runtime/base/result.h"
#include "runtime/vision/frame.h"

namespace aspect {

// Row by row, top to bottom. Kept and reused from view to view: render() only grows it.
struct Picture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;       // interleaved, 3 bytes a pixel: round(255 * linear colour)
  std::vector<std::uint16_t> surface;  // primitive index + 1, 0 = background
  std::vector<float> depth;            // distance along the camera's z axis, +inf = background

  // Every pixel outside is background; inside there may be background too, since the box is found
  // by projecting bounds (on the pictures of the clean cases it is 0 to 5 pixels too wide a side).
  // Empty where nothing can be seen. Later stages need not look outside.
  Box foreground;

  TileMap tiles;  // working memory of render()
};

// Immutable once made; render() may be called from several threads at once, each with its own
// Picture. The same scene and camera give the same bytes in any thread. They can differ between
// processors with different vector instructions where a ray passes within 0.001 pixel of a border.
class Renderer {
 public:
  // Fails where the scene holds something that cannot be rendered: no primitives, more than 65534
  // of them, a surface that is not there, a number that is not finite, a polygon of fewer than 3
  // vertices, a cone without length, a mesh without triangles or with a vertex that is not there.
  static Result<Renderer> create(const Scene& scene);

  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  // Writes every pixel once, at the camera's size. Surfaces nearer than the camera's centre are
  // behind it; any position is allowed, inside a surface too.
  void render(const Camera& camera, Picture& picture) const;

 private:
  struct Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace aspect
