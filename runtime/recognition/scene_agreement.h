// How far a drawn object is there, before whatever stands behind it and beside others.
#pragma once

#include "runtime/recognition/model_drawing.h"
#include "runtime/recognition/seen_colours.h"

namespace aspect {

struct SceneAgreement {
  // The share of drawn cells whose colour is seen, what may be hidden counting a little less than
  // the rest, less what goes on beyond the outline in the colour of the surface beside it.
  float score = 0;
  float inside = 0;   // the share of the drawn cells that lies within the picture
  int colours = 0;    // of the object that are seen
  float margin = -1;  // of the score over what so many colours need: the object is there from 0 on
  Box box;            // what is drawn, within the picture
};

// O(cells).
SceneAgreement scene_agreement(const ModelDrawing& drawing, const CameraModel& camera,
                               const SeenColours& seen, int width_px, int height_px);

}  // namespace aspect
