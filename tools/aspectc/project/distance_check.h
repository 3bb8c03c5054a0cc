// Whether an object can be seen over the whole range of distances that a project promises.
#pragma once

#include <string>
#include <vector>

#include "compiler/scene/scene.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// The distance from a point to the farthest of the scene.
double radius_around(const Scene& scene, const Eigen::Vector3d& centre);

// Largest radius of a sphere around studio.at that lies in the picture from that distance.
double fitting_radius_at(const Studio& studio, double distance);

// Pixels of the smallest contour as seen from 42 directions at that distance: for each primitive
// the largest contour of its colour that most of it is part of, and of these the least. 0 where
// nothing is seen.
struct SmallestContour {
  int area_px = 0;
  int surface = 0;  // the primitive's number, from 1
};
SmallestContour smallest_contour_at(const Scene& scene, const VisionParameters& vision,
                                    double distance);

// A line where the object leaves the picture at `near`, and one where at `far` a contour is smaller
// than the segmentation keeps. The scene must be one that can be rendered.
std::vector<std::string> distance_warnings(const Scene& scene, const VisionParameters& vision,
                                           double near, double far);

}  // namespace aspect
