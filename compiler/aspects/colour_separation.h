// How far apart two colours are for the segmentation.
#pragma once

#include <Eigen/Core>

#include "compiler/scene/scene.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// What a surface shows in full light, linear, 255 * it in a picture: under the ambient light alone,
// or with lamps.
Eigen::Vector3d colour_seen(const Scene& scene, const Surface& surface);

// The brightness that the segmentation compares with intensity_min, 0..765: r + g + b of colours,
// three times the value of a sensor of grey ones.
double intensity_seen(const Eigen::Vector3d& colour, const VisionParameters& vision);

// The largest difference of a colour share (of 255), or of brightness (r + g + b, of 765) to a
// sensor of grey values, and the step that the segmentation still takes for one region.
struct ColourGap {
  double difference = 0;
  double step = 1;

  double separation() const { return difference / step; }  // two regions above 1
};

// Between linear colours. No difference where one of them is so dark that it is background.
ColourGap colour_gap(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const VisionParameters& vision);

// colour_gap().separation(): in the steps that the segmentation takes as the border between two
// regions.
double colour_separation(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const VisionParameters& vision);

}  // namespace aspect
