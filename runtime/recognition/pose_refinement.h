// A pose refined against the picture: the borders of the drawn model are looked for along their
// normals, and Levenberg-Marquardt on SE(3) moves the object so that they meet (Drummond and
// Cipolla, Real-time visual tracking of complex structures, 2002).
#pragma once

#include <array>

#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/model_borders.h"
#include "runtime/recognition/model_drawing.h"
#include "runtime/recognition/seen_colours.h"

namespace aspect {

struct RefinedPose {
  RigidPose pose;
  int borders_found = 0;      // of the drawn model, with one of the right colours near by
  float reprojection_px = 0;  // root mean square of their distances
  // The share of the borders drawn that are found where they are drawn, to a pixel and a half.
  float borders_met = 0;
  // Of three turns about the camera's axes through the object's centre, in radians, and of its
  // place, in scene units; row by row.
  std::array<double, 36> covariance{};
};

struct RefinementScratch {
  ModelDrawing drawing;
  std::array<BorderPoint, kMaxBorderPoints> points{};
};

// What stands behind the object: the background of what is alone, or anything.
enum class Behind : std::uint8_t { background, anything };

struct RefinementDetail {
  // Of a drawing along a side, but for the last round's, which has the most. More is more exact.
  int round_cells = 48;
  // The borders that a drawing shows serve for so many rounds. More costs less; from far away
  // others come into sight on the way.
  int rounds_a_drawing = 1;
};

// From where `start` shows the object to within about `reach_px`. Nothing is refined where no more
// than a handful of borders is found. `box` is what the blob fills.
RefinedPose refine_pose(const ObjectModel& model, const CameraModel& camera,
                        const SeenColours& seen, const Box& box, const RigidPose& start, int rounds,
                        float reach_px, RefinementScratch& scratch,
                        Behind behind = Behind::background, const RefinementDetail& detail = {});

// What share of the object and the blob together is as drawn, 0 to 1, colours compared cell by
// cell. Blur eats thin faces and the rims of others, the more the smaller an object is seen:
// `all_but_rims` takes a cell's neighbours in the drawing for as good.
struct Agreement {
  float all = 0, all_but_rims = 0;
};
Agreement agreement(const ModelDrawing& drawing, const CameraModel& camera,
                    const SeenColours& seen);

}  // namespace aspect
