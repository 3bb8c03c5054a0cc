// An object's model drawn flat in its own colours, with its edges, for people to look at.
#pragma once

#include <opencv2/core.hpp>

#include "runtime/recognition/object_model.h"

namespace aspect {

struct ModelPicture {
  cv::Mat picture;  // 8 bits, BGR, on kPaper of paper.h
  cv::Mat covered;  // 8 bits: 255 where the model is
};

// A square as seen from `direction_unit`, upright as the model's views are, from so far away that
// the model fits from every side: all pictures of a model have one scale. Within a surface pixels
// have its very colour; edges are dark, where colours meet, surfaces bend by more than 25 degrees
// or one ends before another. Without a model only paper. O(side^2 + triangles).
ModelPicture model_picture(const ObjectModel& model, const Vector3d& direction_unit,
                           double field_of_view_deg, int side_px);

}  // namespace aspect
