// How well the regions of a frame are the surfaces that the model, at its pose, shows there.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "runtime/vision/vision.h"

namespace aspect {

// A frame with the areas that should each be a region: connected pixels of one paint.
struct WantedAreas {
  cv::Mat picture;           // colours, blue first
  cv::Mat areas;             // CV_32S: the number of the area, from 1; 0: none
  std::vector<int> area_px;  // by number - 1
};

// Areas that are smaller or thinner than any segmentation keeps do not count. `paints` is
// SurfaceMapper's map.
WantedAreas wanted_areas(const cv::Mat& picture, const cv::Mat& paints);

class RegionMatch {
 public:
  // The mean over areas of the largest share, of area and region together, that both have (0: no
  // region at all there, 1: one that is the area). The regions live until the next call.
  double score(const WantedAreas& wanted, const VisionParameters& parameters);
  const RegionMap& regions() const { return vision_.regions(); }

 private:
  PlannedMemory memory_;
  Vision vision_;
};

}  // namespace aspect
