// Values of [segmentation] with which regions are more nearly the surfaces that the model shows.
#pragma once

#include <string>
#include <vector>

#include "runtime/vision/vision_parameters.h"
#include "tools/calibrate/segmentation/region_match.h"

namespace aspect {

struct SearchedValues {
  VisionParameters parameters;
  double score_before = 0, score_after = 0;  // mean over the frames searched on
};

// One value after the other, as long as that gains something: intensity_min, chroma_step,
// noise_steps, intensity_step. Values that gain next to nothing stay as they are.
SearchedValues search_values(const std::vector<WantedAreas>& frames, const VisionParameters& start);

// On frames that were not searched on.
struct HeldOut {
  double score_before = 0, score_after = 0;
  double gain = 0, gain_error = 0;  // mean of the frames' gains, and its standard error
  bool is_better = false;           // by more than chance and more than a trifle
};
HeldOut compare_values(const std::vector<WantedAreas>& frames, const VisionParameters& before,
                       const VisionParameters& after);

// The keys of [segmentation] that differ, with their values.
std::vector<std::pair<std::string, int>> changed_values(const VisionParameters& before,
                                                        const VisionParameters& after);

}  // namespace aspect
