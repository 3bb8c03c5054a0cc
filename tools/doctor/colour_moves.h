// Colours moved apart until the segmentation separates what touches.
#pragma once

#include "tools/doctor/sight.h"

namespace aspect {

struct ColourMove {
  Eigen::Vector3d before{0, 0, 0}, after{0, 0, 0};     // diffuse
  double separation_before = 0, separation_after = 0;  // least, from what it touches
};

// Where touching colours are one to the segmentation, one of the two gets the nearest colour that
// is 1.25 steps from everything it touches, looked for along 98 directions by half a grey value.
// Colours that are the same stay the same. Pairs that no colour separates are left. The sight must
// be the scene's.
std::vector<ColourMove> separate_colours(Scene& scene, ColourGroups groups, const Sight& sight,
                                         const VisionParameters& vision);

}  // namespace aspect
