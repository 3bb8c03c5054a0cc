// What a mesh loses when its colours are merged.
#pragma once

#include <opencv2/core.hpp>

#include "tools/aspectc/project/prepared_object.h"
#include "tools/doctor/finding.h"

namespace aspect {

// `mesh` in the colours that it has without being merged.
Finding merging_finding(const ColouredMesh& mesh, std::size_t count, const VisionParameters& vision,
                        const std::string& file);

// From three sides, one below the other: as it is on the left, merged on the right. Both scenes
// must be ones that can be rendered.
cv::Mat merging_picture(const Scene& before, const Scene& after);

}  // namespace aspect
