// What is seen of a scene from 42 directions, as the segmentation sees it.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// Surfaces that show one colour, so that they are meant to be alike. Textured ones are of none.
struct ColourGroups {
  struct Group {
    Eigen::Vector3d seen{0, 0, 0};      // colour_seen()
    std::vector<std::size_t> surfaces;  // into Scene::surfaces; those in use
  };
  static constexpr std::size_t kNone = ~std::size_t{0};

  std::vector<Group> groups;          // in the order of their first primitives
  std::vector<std::size_t> group_of;  // by primitive

  bool are_two(std::size_t a, std::size_t b) const { return a != b && a != kNone && b != kNone; }
};
ColourGroups colour_groups(const Scene& scene);

// Where two surfaces touch in pictures: neighbouring pixels of both at nearly one depth.
struct Border {
  std::size_t pixels = 0;
  std::size_t merged = 0;  // where the pixels' own colours, shaded as they are, count as one
  double least_separation = 0;
};

struct Sight {
  struct Part {
    std::size_t most_px = 0;               // in one picture
    std::size_t seen_px = 0, dark_px = 0;  // in all; dark: counted as background
    double kept_px = 0;  // largest contour of its colour that it is mostly part of; 0: none
    double thin_px = 0;  // the same if thin filaments were kept
  };
  std::vector<Part> parts;                                                   // by primitive
  std::map<std::pair<std::size_t, std::size_t>, Border> borders;             // by two colour groups
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> alike_borders;  // by two primitives
};

// At that distance from studio.at.
Sight look_around(const Scene& scene, const Renderer& renderer, const ColourGroups& groups,
                  const VisionParameters& vision, double distance);

}  // namespace aspect
