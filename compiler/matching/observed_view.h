// What the compiler keeps of a view: its graph, and where on the object every contour lies.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/vision/feature.h"
#include "runtime/vision/view_graph.h"

namespace aspect {

struct SurfaceShare {
  std::uint16_t surface = 0;  // primitive index + 1
  std::uint32_t pixels = 0;
};

struct ObservedContour {
  ContourFeature feature;
  bool external = true;
  ShapeClass shape = ShapeClass::other;
  float area_px = 0;
  std::array<float, 3> centre_object{};  // mean of the surface points that it shows
  std::vector<SurfaceShare> surfaces;    // the surfaces that it shows, by id
};

struct ObservedView {
  Eigen::Vector3d direction{0, 0, 1};     // unit vector from the object's centre to the camera
  Eigen::Vector3d right{1, 0, 0};         // the camera's x axis in object coordinates
  float area_px = 0;                      // of the object's outline
  std::vector<ObservedContour> contours;  // external ones first
  std::vector<Relation> relations;        // between external contours
  std::size_t external_count = 0;         // nodes that matching works with
};

}  // namespace aspect
