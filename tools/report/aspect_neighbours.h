// Which aspects lie beside each other on the viewing sphere.
#pragma once

#include <vector>

#include "tools/report/sphere_mesh.h"

namespace aspect {

struct AspectNeighbour {
  std::int32_t aspect = kNoClass;
  double border_deg = 0;  // length of the border, or of the middle of the strip between them
  int gap = 0;            // patches of no aspect that lie between; 0: they touch
};

// By aspect: its neighbours, longest border first, those that touch it before the others. Two
// aspects are neighbours across a strip where it is no wider than kWidestGap patches and longer
// than kLeastAcross_deg. O(pieces).
inline constexpr int kWidestGap = 6;
inline constexpr double kLeastAcross_deg = 1;
std::vector<std::vector<AspectNeighbour>> aspect_neighbours(const SphereMesh& mesh,
                                                            std::size_t aspects);

}  // namespace aspect
