// What a texture shows at a point of a surface.
#pragma once

#include <Eigen/Core>

#include "compiler/scene/scene.h"

namespace aspect {

// A point's u and v on its primitive, 0..1 each:
// polygon: over the rectangle around it whose side runs along its first edge, u that way, v to the
//   left of it seen from where the vertices run counter-clockwise;
// patch: the weights of its second and third vertex;
// sphere: longitude from x towards y over a full turn, latitude from -z to z, by the axes of the
//   frame in which the surface is written;
// ring: over the square around it; cone and cylinder: u around the axis over a full turn,
//   counter-clockwise seen from the apex, v from base to apex; both start from the frame's x axis,
//   or from its y axis where x is nearly the normal or axis.
// Any other shape: x and y of the frame.
Eigen::Vector2d map_position(const Primitive& primitive, const Texture& texture,
                             const Eigen::Vector3d& point_object);

Eigen::Vector3d texture_color(const Texture& texture, const Primitive& primitive,
                              const Eigen::Vector3d& point_object);

}  // namespace aspect
