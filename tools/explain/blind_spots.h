// Where on the viewing sphere a model is blind, and why.
#pragma once

#include "tools/explain/trials.h"

namespace aspect {

struct BlindSpots {
  double share = 0;         // of the sphere
  std::vector<Spot> spots;  // the largest, largest first
};

// The patches that are of no aspect, gathered about the largest of them. What stands in the way is
// found by rendering the corners of a few.
BlindSpots find_blind_spots(const EvaluatedObject& object, const Faces& faces,
                            const CompileOptions& options);

// Where the wrong answers come from; shares are of all trials.
std::vector<Spot> failing_spots(const std::vector<Trial>& trials);

}  // namespace aspect
