// What of a blob is compared with a class: its external contours, each as a feature; or what light
// has parted taken together again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/recognition/assignment.h"
#include "runtime/vision/feature.h"
#include "runtime/vision/segment.h"
#include "runtime/vision/view_graph.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

struct BlobFeatures {
  std::array<ContourFeature, kMaxSide> features;
  // Of the view graph's contours; the largest one of those taken together.
  std::array<std::uint16_t, kMaxSide> contours;
  std::size_t count = 0;

  std::span<const ContourFeature> seen() const { return std::span(features).first(count); }
};

// Holes say nothing that the regions around and in them do not.
void features_of(const ViewGraph& graph, std::size_t blob, BlobFeatures& out);

// Faces of one colour that meet are one region to the compiler, which knows no light, and two to a
// camera, since they are not equally bright. Regions of one colour (as far as chroma_step and
// noise_steps tell) that touch each other along three pixels or more are one feature here. False,
// and nothing useful in `out`, where there are none. O(contours^2 + runs).
bool join_alike(const ViewGraph& graph, const RegionMap& regions, std::size_t blob,
                const VisionParameters& parameters, BlobFeatures& out);

}  // namespace aspect
