// How far a drawn object is there, before whatever stands behind it and beside others.
#pragma once

#include <bitset>

#include "runtime/recognition/model_drawing.h"
#include "runtime/recognition/seen_colours.h"

namespace aspect {

// By label of a region.
using Labels = std::bitset<kMaxRegions + 1>;

struct SceneAgreement {
  // The share of drawn cells whose colour is seen, what may be hidden counting a little less than
  // the rest, less what goes on beyond the outline in the colour of the surface beside it.
  float score = 0;
  float inside = 0;  // the share of the drawn cells that lies within the picture, not hidden
  int colours = 0;   // of the object that are seen
  // Of the log odds that the object is there over what is needed to say so, divided by
  // kLogOddsOfMargin: from 0 on it is.
  float margin = -1;
  Box box;           // what is drawn, within the picture
  Labels explained;  // regions that are for the most part seen as drawn
};

inline constexpr double kLogOddsOfMargin = 14.2;

// `borders_met`: of RefinedPose, 1 where nothing has been refined yet. Regions `of_others` hide the
// object. O(cells).
SceneAgreement scene_agreement(const ModelDrawing& drawing, const CameraModel& camera,
                               const SeenColours& seen, int width_px, int height_px,
                               float borders_met, const Labels& of_others);

}  // namespace aspect
