// Lights as seen from a point of a surface.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "compiler/render/sampling.h"
#include "compiler/scene/scene.h"

namespace aspect {

struct LightSample {
  Eigen::Vector3d to_light;  // unit length
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector3d color;  // what arrives where nothing is in the way
};

// A light is a point, but a spherical one is light.samples points spread over the disc that it
// shows to the surface, each with its share of the colour. `turn` turns their pattern. Nothing
// where the point lies outside a spot.
std::vector<LightSample> samples_of(const Light& light, const Eigen::Vector3d& point_object,
                                    double turn);

}  // namespace aspect
