// Which colours to change so that faces are not mistaken any more, and whether that helps.
#pragma once

#include "tools/explain/trials.h"

namespace aspect {

// For the faces that are mistaken most, the colour of a palette that is farthest from all others.
// Pairs whose colours the segmentation separates well already are left alone: it is not their
// colour that confuses.
std::vector<ColourChange> colour_changes(const std::vector<FaceConfusion>& confusions,
                                         const Faces& faces, const VisionParameters& vision);

// Compiles the scene with the changes, at a low level and without a store, and runs the same trials
// again.
Result<Cure> try_changes(const Recipe& recipe, const std::vector<ColourChange>& changes,
                         const Faces& faces, const std::vector<Trial>& before,
                         const ExplainSettings& settings);

}  // namespace aspect
