// An object under a lamp.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compiler/render/dice.h"
#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"

namespace aspect {

// A scene that has lamps keeps them. One that shows plain colours gets a lamp far away, in one of
// eight directions: a side that faces it shows the colour, one in its own shadow two fifths of it.
class LitObject {
 public:
  static Result<LitObject> create(const Scene& scene);

  // Under a lamp on the side of somebody who looks from that direction.
  const Renderer& seen_from(const Eigen::Vector3d& view, Dice& dice) const;

 private:
  std::vector<Renderer> renderers_;
  std::vector<Eigen::Vector3d> lamps_;  // where they are, unit vectors; none: the scene's
};

}  // namespace aspect
