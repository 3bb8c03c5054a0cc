// Writes runs of pixels into a picture.
#pragma once

#include "compiler/render/renderer.h"
#include "compiler/render/shading.h"
#include "compiler/render/tile_map.h"

namespace aspect {

class PixelWriter {
 public:
  // The picture must have its size already.
  explicit PixelWriter(Picture& picture) : picture_(picture) {}

  void fill_background(const Box& box, const Rgb& color);

  // One plane's surface all over the box.
  void fill_plane(const Box& box, std::uint16_t surface, const Rgb& color,
                  const InverseDepth& plane);

  void put(int x, int y, std::uint16_t surface, const Rgb& color, float depth) {
    const std::size_t k = pixel(x, y);
    picture_.surface[k] = surface;
    picture_.depth[k] = depth;
    picture_.rgb[3 * k] = color[0];
    picture_.rgb[3 * k + 1] = color[1];
    picture_.rgb[3 * k + 2] = color[2];
  }

 private:
  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width_px) +
           static_cast<std::size_t>(x);
  }

  Picture& picture_;
};

}  // namespace aspect
