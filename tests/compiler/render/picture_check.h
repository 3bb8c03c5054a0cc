// Holds a picture against the reference tracer, pixel by pixel.
#pragma once

#include <string>

#include "compiler/render/camera.h"
#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"

namespace aspect {

struct PictureComparison {
  int foreground = 0;  // pixels where the reference sees a surface
  int compared = 0;    // of these and the background, those that are no border
  int wrong_id = 0;    // must be 0
  double worst_depth = 0;
  std::string first_wrong;  // for the message
};

// A pixel is a border where the reference's id changes within 0.01 pixel.
PictureComparison compare_with_reference(const Scene& scene, const Camera& camera,
                                         const Picture& picture);

// Renders and requires all ids right, all depths within 1e-4, and at most 1 in 50 pixels a border.
void require_like_reference(const Scene& scene, const Renderer& renderer, const Camera& camera);

bool same_bytes(const Picture& a, const Picture& b);

}  // namespace aspect
