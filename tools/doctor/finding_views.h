// From where a diagnosis is seen best.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compiler/render/renderer.h"
#include "tools/doctor/diagnosis.h"
#include "tools/doctor/sight.h"

namespace aspect {

inline constexpr std::size_t kMostViews = 4;

// Of 42 directions those that together show the most of all findings, the one that shows the most
// first; errors weigh more than warnings, and those more than notes. At least one. `renderer` and
// `studio` are of scene_for_views(), `groups` of the scene that was diagnosed.
std::vector<Eigen::Vector3d> best_views(const Diagnosis& diagnosis, const ColourGroups& groups,
                                        const Renderer& renderer, const Studio& studio);

}  // namespace aspect
