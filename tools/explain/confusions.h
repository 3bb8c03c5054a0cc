// Which aspects and which faces are mistaken for which.
#pragma once

#include "tools/explain/trials.h"

namespace aspect {

std::vector<AspectConfusion> aspect_confusions(const std::vector<Trial>& trials,
                                               const Faces& faces);

// Pairs of faces that were matched though they are different ones; each pair once, most views
// first.
std::vector<FaceConfusion> face_confusions(const std::vector<Trial>& trials, const Faces& faces,
                                           const VisionParameters& vision);

}  // namespace aspect
