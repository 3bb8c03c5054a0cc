// Colours that the segmentation cannot tell apart or see.
#pragma once

#include "tools/doctor/finding.h"
#include "tools/doctor/sight.h"

namespace aspect {

// More colours than can be told apart. Needs no picture.
std::vector<Finding> check_colours(const ColourGroups& groups, const VisionParameters& vision);

// Colours that the scene names and that are not there: errors, but notes where the user has given
// one to stand for them.
std::vector<Finding> check_missing(const Scene& scene, bool given);

// Colours that touch and do not separate: by themselves or, under lamps, in their shading. Surfaces
// of one and the same colour that touch are a note.
std::vector<Finding> check_borders(const Scene& scene, const ColourGroups& groups,
                                   const Sight& sight, const VisionParameters& vision);

// Surfaces so dark that they count as background.
std::vector<Finding> check_darkness(const Scene& scene, const ColourGroups& groups,
                                    const Sight& sight, const VisionParameters& vision);

// Whether two colours that touch are one to the segmentation, in full light.
bool is_inseparable(const ColourGroups::Group& a, const ColourGroups::Group& b,
                    const VisionParameters& vision);

// By how much they differ, and what would be needed.
std::string inseparable_words(const ColourGroups::Group& a, const ColourGroups::Group& b,
                              const VisionParameters& vision);

// Too dark to be seen.
bool is_background(const Eigen::Vector3d& colour, const VisionParameters& vision);

// "0.85 0.1 0.1 (shares 206.4 24.3 24.3)": of 255.
std::string colour_words(const Eigen::Vector3d& colour);

}  // namespace aspect
